// The C interface of engine.wasm (tools/library/include/rigsound.h) as a class. Used where sound is made: nothing here
// looks at the page.

export interface Levels { peak: number; rms: number; limiterGain: number; lostClicks: number }
export interface Drilling { situation: string; hammering: boolean; impactsHz: number }
/** One call of a setter, at once or from a block on. */
export interface Change { call: 'set' | 'control'; name: string; boom: number; value: number }

type Call = (...values: number[]) => number;
interface Exports extends Record<string, unknown> { memory: WebAssembly.Memory }

const kLevelBytes = 24, kDrillingBytes = 12;

// The audio thread has neither TextEncoder nor TextDecoder; names are ASCII, messages nearly so.
const bytesOf = (text: string): Uint8Array => Uint8Array.from(`${text}\0`, (letter) => letter.charCodeAt(0));

export class Engine {
  private readonly exports: Exports;
  private readonly scratch: number;
  private readonly names = new Map<string, number>();
  private rig = 0;
  private out = 0;
  private samples = new Float32Array(0);
  rate = 0;
  block = 0;
  channels = 0;
  booms = 0;

  /** Throws an Error with the engine's own line when the set cannot be played. */
  constructor(module: WebAssembly.Module, set: Uint8Array) {
    this.exports = new WebAssembly.Instance(module, {
      env: { emscripten_notify_memory_growth: () => undefined },
      wasi_snapshot_preview1: { proc_exit: (code: number) => { throw new Error(`the engine ended with ${code}`); } },
    }).exports as Exports;
    this.call('_initialize');
    this.scratch = this.call('malloc', Math.max(kLevelBytes, kDrillingBytes));
    this.open(set);
  }

  /** Another set in place of this one, in the same memory. Throws as the constructor; nothing can be played then. */
  open(set: Uint8Array): void {
    if (this.rig !== 0) this.call('rigsound_close', this.rig);
    const at = this.put(set);
    this.rig = this.call('rigsound_open_memory', at, set.length);
    this.call('free', at);
    if (this.rig === 0) throw new Error(this.text(this.call('rigsound_last_error', 0)));
    this.rate = this.call('rigsound_rate', this.rig);
    this.block = this.call('rigsound_block', this.rig);
    this.channels = this.call('rigsound_channels', this.rig);
    this.booms = this.call('rigsound_booms', this.rig);
    if (this.out !== 0) this.call('free', this.out);
    this.out = this.call('malloc', this.block * this.channels * 4);
    this.samples = new Float32Array(0);
  }

  /** Throws an Error with the engine's own line when the value is refused. */
  change({ call, name, boom, value }: Change): void {
    if (this.call(`rigsound_${call}`, this.rig, this.name(name), boom, value) !== 0)
      throw new Error(this.text(this.call('rigsound_last_error', this.rig)));
  }

  /** One block, interleaved; valid until the next call. */
  process(): Float32Array {
    this.call('rigsound_process', this.rig, this.out);
    if (this.samples.buffer !== this.exports.memory.buffer)
      this.samples = new Float32Array(this.exports.memory.buffer, this.out, this.block * this.channels);
    return this.samples;
  }

  levels(): Levels {
    this.call('rigsound_meters', this.rig, this.scratch);
    const view = new DataView(this.exports.memory.buffer, this.scratch, kLevelBytes);
    return { peak: view.getFloat32(0, true), rms: view.getFloat32(4, true), limiterGain: view.getFloat32(8, true),
      lostClicks: Number(view.getBigUint64(16, true)) };
  }

  drilling(boom: number): Drilling {
    this.call('rigsound_watch', this.rig, boom, this.scratch);
    const view = new DataView(this.exports.memory.buffer, this.scratch, kDrillingBytes);
    return { situation: this.text(view.getUint32(0, true)), hammering: view.getInt32(4, true) !== 0,
      impactsHz: view.getFloat32(8, true) };
  }

  private call(name: string, ...values: number[]): number {
    return (this.exports[name] as Call)(...values);
  }

  private put(bytes: Uint8Array): number {
    const at = this.call('malloc', bytes.length);
    new Uint8Array(this.exports.memory.buffer).set(bytes, at);
    return at;
  }

  /** Where a name lies; it stays there. */
  private name(text: string): number {
    let at = this.names.get(text);
    if (at === undefined) this.names.set(text, at = this.put(bytesOf(text)));
    return at;
  }

  private text(at: number): string {
    const bytes = new Uint8Array(this.exports.memory.buffer);
    return String.fromCharCode(...bytes.subarray(at, bytes.indexOf(0, at)));
  }
}
