// What the page and the audio thread say to one another.
import type { Change, Drilling, Levels } from './engine';

/** A change that acts from the first block on that begins at `frame` or later. */
export interface TimedChange extends Change { frame: number }

export interface ProcessorOptions {
  module: WebAssembly.Module;
  set: Uint8Array;
  changes?: TimedChange[];
}

export type ToEngine =
  | { kind: 'change'; change: Change }
  /** `change` for one block, then `back`: what is told at once would cancel itself. */
  | { kind: 'pulse'; change: Change; back: Change }
  /** Another packed set, from its first block on, with what was set so far. */
  | { kind: 'load'; set: Uint8Array }
  /** The changes of a timeline from `from_frame` on; the rig starts anew, in the state it then has. */
  | { kind: 'play'; changes: TimedChange[]; fromFrame: number }
  /** The timeline stands still; the state stays. */
  | { kind: 'pause' }
  | { kind: 'end' };

export type FromEngine =
  | { kind: 'ready'; rate: number; block: number; channels: number; booms: number }
  | { kind: 'failed'; error: string }
  | { kind: 'refused'; error: string }
  | { kind: 'levels'; levels: Levels; drilling: Drilling[]; frame: number; playing: boolean };
