// The whole rig at hand: what is turned goes to the engine, what the engine did comes back. Used by the studio and by the
// exported page.
import { outputAt, resume } from '../audio/output';
import { RigPlayer, type Parts } from '../audio/rig_player';
import { spectrumView } from '../audio/scope';
import { h } from '../dom/element';
import { button, choice, pick } from '../dom/fields';
import { clock } from '../dom/number_text';
import type { Rig, Timeline } from '../server/documents';
import type { Shortcut } from '../shell/shortcuts';
import { rigControls } from './controls';
import { levelMeters } from './level_meters';
import { changesFrom, changesOf } from './timeline_changes';
import { TimelineView } from './timeline_view';

export interface RigViewOptions {
  parts: Parts;
  set: Uint8Array;
  rig: Rig;
  logs: { id: string; name: string }[];
  timelineOf(id: string): Promise<Timeline>;
}

const kFeedStep_bar = 5;

export const openRigView = async (place: HTMLElement, tools: HTMLElement, options: RigViewOptions) => {
  const { rig } = options;
  const context = await outputAt(rig.rate);
  const player = await RigPlayer.open(context, options.parts, options.set);
  let sounding = false, boom = 0;
  let timeline: { data: Timeline; view: TimelineView; changes: ReturnType<typeof changesOf>; next: number; at_s: number } | null = null;
  let following = false;

  const problem = h('p', { class: 'note', role: 'status' });
  player.onProblem = (line) => { problem.textContent = line; };
  const controls = rigControls(rig, (change) => {
    problem.textContent = '';
    player.change(change);
  });
  controls.all().forEach((change) => player.change(change));

  const meters = levelMeters(), scope = spectrumView(player.node);
  const play = button('Play', () => sound(!sounding), { class: 'main play', 'aria-keyshortcuts': 'Space' });
  const sound = (wanted: boolean): void => {
    sounding = wanted;
    void resume();
    if (wanted) player.node.connect(context.destination);
    else {
      player.node.disconnect(context.destination);
      meters.rest();
    }
    play.textContent = wanted ? 'Stop' : 'Play';
    play.setAttribute('aria-pressed', String(wanted));
  };

  const follow = (wanted: boolean, from_s = timeline?.at_s ?? 0): void => {
    following = wanted && timeline !== null;
    followButton.textContent = following ? 'Pause log' : 'Play log';
    if (!timeline || !following) return player.pause();
    const frame = Math.floor(from_s * rig.rate / rig.block) * rig.block;
    timeline.at_s = from_s;
    timeline.next = 0;
    player.play(changesFrom(timeline.changes, frame), frame);
    if (!sounding) sound(true);
  };
  const followButton = button('Play log', () => follow(!following), { disabled: true, 'aria-keyshortcuts': 'l' });
  const where = h('output', { class: 'quiet' });
  const showAt = (seconds: number): void => {
    if (!timeline) return;
    timeline.at_s = seconds;
    timeline.view.show(seconds);
    where.textContent = `${clock(seconds, 1)} of ${clock(timeline.data.seconds, 1)}`;
    for (let change; (change = timeline.changes[timeline.next]) && change.frame <= seconds * rig.rate; ++timeline.next)
      controls.show(change.name, change.boom, change.value);
  };
  const along = h('div', {});
  const choose = async (id: string): Promise<void> => {
    follow(false);
    timeline?.view.close();
    timeline = null;
    followButton.disabled = id === '';
    where.textContent = '';
    if (id === '') return along.replaceChildren();
    try {
      const data = await options.timelineOf(id);
      const view = new TimelineView(data, boom, (seconds) => { if (timeline) timeline.next = 0; showAt(seconds); if (following) follow(true, seconds); });
      timeline = { data, view, changes: changesOf(data, rig), next: 0, at_s: 0 };
      along.replaceChildren(view.element);
      showAt(0);
    } catch (error) {
      problem.textContent = error instanceof Error ? error.message : String(error);
      followButton.disabled = true;
    }
  };

  player.onLevels = (levels) => {
    if (sounding) meters.show(levels, boom);
    else meters.rest();
    if (!following || !timeline) return;
    showAt(Math.min(timeline.data.seconds, levels.frame / rig.rate));
    if (levels.frame / rig.rate >= timeline.data.seconds) {
      follow(false);
      timeline.at_s = 0;
      timeline.next = 0;
    }
  };

  tools.append(play);
  const booms = rig.booms.length < 2 ? null : choice('Boom', rig.booms.map((name, n) => [String(n), name] as const), '0', (value) => {
    boom = Number(value);
    controls.showBoom(boom);
  });
  const logs = options.logs.length === 0 ? null : h('section', { class: 'panel stack', 'aria-label': 'Bus log' },
    h('div', { class: 'row' }, h('h2', {}, 'Bus log'), pick('', [['', 'none'], ...options.logs.map(({ id, name }) => [id, name] as const)], '', (id) => void choose(id)).element,
      followButton, where), along);
  logs?.querySelector('select')?.setAttribute('aria-label', 'Bus log to play');
  place.replaceChildren(problem, ...(booms ? [booms.element] : []),
    h('div', { class: 'rig' }, controls.lever, controls.signals, h('div', { class: 'stack' }, meters.element, h('div', { class: 'panel' }, scope.element))),
    ...(logs ? [logs] : []),
    h('section', { class: 'panel', 'aria-label': 'Six controls of the drill' }, h('h2', {}, 'The drill’s six controls'), controls.six));

  const nudge = (by: number): void => {
    const range = rig.signals.find(({ name }) => name === 'feed_pressure_bar');
    const value = Math.max(range?.min ?? 0, Math.min(range?.max ?? 300, controls.valueOf('feed_pressure_bar', boom) + by));
    controls.show('feed_pressure_bar', boom, value);
    player.change({ call: 'set', name: 'feed_pressure_bar', boom, value });
  };
  const shortcuts: Shortcut[] = [
    { key: ' ', does: 'Play, stop', run: () => sound(!sounding) },
    { key: 'ArrowUp', does: 'More feed', run: () => nudge(kFeedStep_bar) },
    { key: 'ArrowDown', does: 'Less feed', run: () => nudge(-kFeedStep_bar) },
    ...(logs ? [{ key: 'l', does: 'Play or pause the log', run: () => follow(!following) }] : []),
  ];
  return {
    shortcuts, player,
    close: () => { scope.close(); timeline?.view.close(); player.close(); },
  };
};
