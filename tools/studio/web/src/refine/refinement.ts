// What a person may change of a bank, and how it goes to the engine and to the server.
import type { Change } from '../audio/engine';
import type { Refinement } from '../bank/bank_document';
import type { Control } from '../server/documents';

export const neutralOf = (controls: Control[], version: string): Refinement =>
  ({ version, controls: Object.fromEntries(controls.map(({ name, neutral }) => [name, neutral])), dropped: [], trim_db: 0 });

/** The six controls of the engine; the trim is a level like that of the clicks. */
export const changesOf = (refinement: Refinement, controls: Control[]): Change[] => controls.map(({ name, neutral, min, max }) => {
  const own = refinement.controls[name] ?? neutral;
  const value = name === 'mean_amplitude_db' ? Math.max(min, Math.min(max, own + refinement.trim_db)) : own;
  return { call: 'control', name, boom: 0, value };
});

/** The packed set in which that bank alone sounds, without the dropped clicks. */
export const packedPath = (bank: string, clicks: number[], dropped: number[]): string =>
  `/sound_set.rigset?bank=${encodeURIComponent(bank)}${dropped.length ? `&clicks=${clicks.filter((n) => !dropped.includes(n)).join(',')}` : ''}`;
