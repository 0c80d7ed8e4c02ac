// A bus log's states as the changes the engine is told.
import type { TimedChange } from '../audio/messages';
import type { Rig, Timeline } from '../server/documents';

/** Every change in order, at the frame at which the log has it. */
export const changesOf = (timeline: Timeline, rig: Rig): TimedChange[] =>
  timeline.signals.flatMap(({ name, boom, changes }) => changes.map(([time, value]) => ({
    frame: time * rig.rate, call: 'set' as const, name, boom,
    value: value ?? rig.signals.find((signal) => signal.name === name)?.absent ?? 0,
  }))).sort((a, b) => a.frame - b.frame);

/** What is left of them from a frame on: one change a signal for the state there, then the rest. */
export const changesFrom = (changes: TimedChange[], frame: number): TimedChange[] => {
  const state = new Map<string, TimedChange>();
  const rest: TimedChange[] = [];
  for (const change of changes)
    if (change.frame > frame) rest.push(change);
    else state.set(`${change.boom} ${change.name}`, { ...change, frame });
  return [...state.values(), ...rest];
};
