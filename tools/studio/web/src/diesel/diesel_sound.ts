// A diesel that runs in the engine, and the recording of it that can be heard in its place.
import { outputAt, resume } from '../audio/output';
import { RigPlayer } from '../audio/rig_player';
import { servedParts } from '../audio/served_parts';
import { soundFor } from '../audio/sound_files';
import type { Rig } from '../server/documents';
import { askBytes } from '../server/request';
import type { RecordedSpectrum, Setting } from './diesel';

const kSwitch_s = 0.01;

export const openDieselSound = async (name: string, rig: Rig, wrong: (error: unknown) => void) => {
  const context = await outputAt(rig.rate);
  const player = await RigPlayer.open(context, await servedParts(), await askBytes(`/sound_set.rigset?background=${encodeURIComponent(name)}`));
  const model = new GainNode(context, { gain: 1 }), tape = new GainNode(context, { gain: 0 });
  player.node.connect(model).connect(context.destination);
  tape.connect(context.destination);
  player.onProblem = (line) => wrong(new Error(line));
  const tell = (signal: string, value: number): void => player.change({ call: 'set', name: signal, boom: 0, value });
  tell('percussion', 0);
  let setting: Setting = { rpm: 0, load: 0, point: -1 }, running = false, source: AudioBufferSourceNode | null = null;
  const switchTo = (recorded: boolean): void => {
    const now = context.currentTime;
    for (const [gain, on] of [[model, !recorded], [tape, recorded]] as const) {
      gain.gain.cancelScheduledValues(now);
      gain.gain.setTargetAtTime(on ? 1 : 0, now, kSwitch_s / 3);
    }
  };
  const endTape = (): void => {
    source?.stop();
    source?.disconnect();
    source = null;
    switchTo(false);
  };
  return {
    set: (given: Setting) => {
      setting = given;
      tell('engine_load', given.load);
      if (running) tell('engine_rpm', given.rpm);
    },
    /** It starts and dies away as in the cabin. */
    run: (wanted: boolean) => {
      running = wanted;
      void resume();
      tell('engine_rpm', wanted ? setting.rpm : 0);
      if (!wanted) endTape();
    },
    /** The recording in place of the model, over and over. Rejects as requests do. */
    playRecording: async ({ recording, from_s, to_s }: RecordedSpectrum) => {
      const buffer = await soundFor(context, `/recordings/${recording}/audio?from=${from_s}&to=${to_s}`);
      endTape();
      source = new AudioBufferSourceNode(context, { buffer, loop: true });
      source.connect(tape);
      source.start();
      switchTo(true);
    },
    playModel: endTape,
    close: () => { endTape(); player.close(); model.disconnect(); tape.disconnect(); },
  };
};
