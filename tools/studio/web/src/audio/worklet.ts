// The engine on the audio thread. Blocks of the rig fill the browser's quanta, whatever their sizes.
import { Engine, type Change } from './engine';
import type { FromEngine, ProcessorOptions, TimedChange, ToEngine } from './messages';

declare const sampleRate: number;
declare const registerProcessor: (name: string, processor: unknown) => void;
declare class AudioWorkletProcessor {
  readonly port: MessagePort;
}

const kLevelsEvery_s = 1 / 30;
/** Times in seconds are seldom whole frames. */
const kRounding_s = 0.5e-6;

class RigProcessor extends AudioWorkletProcessor {
  private readonly module: WebAssembly.Module;
  private set: Uint8Array;
  private engine: Engine | null = null;
  private readonly state = new Map<string, Change>();
  private readonly pulses: { change: Change; back: Change }[] = [];
  private changes: TimedChange[];
  private next = 0;
  private frame = 0;
  private playing: boolean;
  private block: Float32Array = new Float32Array(0);
  private taken = 0;
  private since = 0;
  private ended = false;

  constructor(options: { processorOptions: ProcessorOptions }) {
    super();
    const { module, set, changes } = options.processorOptions;
    this.module = module;
    this.set = set;
    this.changes = changes ?? [];
    this.playing = changes !== undefined;
    this.open();
    this.port.onmessage = ({ data }: MessageEvent<ToEngine>) => this.take(data);
  }

  private say(message: FromEngine): void { this.port.postMessage(message); }

  private open(): void {
    try {
      const before = this.engine, engine = before ?? new Engine(this.module, this.set);
      if (before) before.open(this.set);
      if (engine.rate !== sampleRate && before) throw new Error(`the set wants ${engine.rate} Hz`);
      this.engine = engine;
      this.block = new Float32Array(0);
      this.taken = 0;
      this.state.forEach((change) => this.apply(change));
      this.say({ kind: 'ready', rate: engine.rate, block: engine.block, channels: engine.channels, booms: engine.booms });
    } catch (error) {
      this.engine = null;
      this.say({ kind: 'failed', error: error instanceof Error ? error.message : String(error) });
    }
  }

  private apply(change: Change): void {
    try {
      this.engine?.change(change);
      this.state.set(`${change.call} ${change.boom} ${change.name}`, change);
    } catch (error) {
      this.say({ kind: 'refused', error: error instanceof Error ? error.message : String(error) });
    }
  }

  private take(message: ToEngine): void {
    if (message.kind === 'change') this.apply(message.change);
    else if (message.kind === 'pulse') this.pulses.push(message);
    else if (message.kind === 'load') {
      this.set = message.set;
      this.open();
    } else if (message.kind === 'play') {
      this.changes = message.changes;
      this.frame = message.fromFrame;
      this.next = 0;
      this.playing = true;
      this.state.clear();
      this.open();
    } else if (message.kind === 'pause') this.playing = false;
    else this.ended = true;
  }

  /** What is said before a block begins acts in it, as in `rigsound render`. */
  private applyDue(): void {
    for (let change; (change = this.changes[this.next]) && change.frame <= this.frame + kRounding_s * sampleRate; ++this.next)
      this.apply(change);
  }

  private fill(engine: Engine, left: Float32Array, right: Float32Array | undefined): void {
    for (let n = 0; n < left.length; ++n) {
      if (this.taken * engine.channels >= this.block.length) {
        if (this.playing) this.applyDue();
        const pulse = this.pulses.shift();
        if (pulse) this.apply(pulse.change);
        this.block = engine.process();
        if (pulse) this.apply(pulse.back);
        this.taken = 0;
        if (this.playing) this.frame += engine.block;
      }
      const at = this.taken++ * engine.channels;
      left[n] = this.block[at] ?? 0;
      if (right) right[n] = this.block[at + Math.min(1, engine.channels - 1)] ?? 0;
    }
  }

  process(_inputs: Float32Array[][], outputs: Float32Array[][]): boolean {
    const left = outputs[0]?.[0], engine = this.engine;
    if (this.ended) return false;
    if (!engine || !left || engine.rate !== sampleRate) return true;
    this.fill(engine, left, outputs[0]?.[1]);
    this.since += left.length;
    if (this.since >= kLevelsEvery_s * sampleRate) {
      this.since = 0;
      this.say({ kind: 'levels', levels: engine.levels(), frame: this.frame, playing: this.playing,
        drilling: Array.from({ length: engine.booms }, (_, boom) => engine.drilling(boom)) });
    }
    return true;
  }
}

registerProcessor('rigsound', RigProcessor);
