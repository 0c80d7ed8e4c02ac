// A steel under the hammer: one blow, or drilling, from the engine; another steel is heard as soon as it is designed.
import { outputAt, resume } from '../audio/output';
import { RigPlayer } from '../audio/rig_player';
import { servedParts } from '../audio/served_parts';
import type { Rig } from '../server/documents';
import { newest } from '../server/newest';
import { askBytes } from '../server/request';
import type { Steel } from './steel';

// Between two steels of a moving slider there is something to hear.
const kPlays_ms = 40;

export const openSteelSound = async (rig: Rig, first: Steel, firstBank: string, wrong: (error: unknown) => void) => {
  let steel = first, bank = firstBank, clicks = false;
  const packed = (): Promise<Uint8Array> => askBytes('/steel/rigset', { method: 'POST', body: { ...steel, ...(bank ? { bank, clicks } : {}) } });
  const context = await outputAt(rig.rate), player = await RigPlayer.open(context, await servedParts(), await packed());
  const hammer = (on: boolean) => ({ call: 'set' as const, name: 'percussion', boom: 0, value: on ? 1 : 0 });
  player.onProblem = (line) => wrong(new Error(line));
  player.change(hammer(false));
  player.change({ call: 'set', name: 'feed_pressure_bar', boom: 0, value: rig.feed.normal_bar });
  player.node.connect(context.destination);
  const next = newest(async () => {
    await player.load(await packed());
    await new Promise((done) => { setTimeout(done, kPlays_ms); });
  }, wrong);
  let drilling = false;
  return {
    setSteel: (given: Steel) => { steel = given; next.ask(undefined); },
    setBank: (name: string) => { bank = name; next.ask(undefined); },
    setClicks: (heard: boolean) => { clicks = heard; next.ask(undefined); },
    blow: () => { void resume(); if (!drilling) player.pulse(hammer(true), hammer(false)); },
    drill: (wanted: boolean) => { void resume(); drilling = wanted; player.change(hammer(wanted)); },
    close: () => { next.end(); player.close(); },
  };
};
