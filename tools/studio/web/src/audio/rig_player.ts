// One rig that sounds: the node whose processor holds the engine, and what is said to it.
import type { Change } from './engine';
import type { FromEngine, ProcessorOptions, TimedChange, ToEngine } from './messages';

export interface Parts {
  module: WebAssembly.Module;
  /** Address of the processor's script. */
  worklet: string;
}

export interface Facts { rate: number; block: number; channels: number; booms: number }
type LevelsMessage = Extract<FromEngine, { kind: 'levels' }>;

export class RigPlayer {
  onLevels: (levels: LevelsMessage) => void = () => undefined;
  onProblem: (line: string) => void = () => undefined;
  private readonly loading: (() => void)[] = [];

  private constructor(readonly context: BaseAudioContext, readonly node: AudioWorkletNode, readonly facts: Facts) {}

  /** Rejects with the engine's own line. `changes`: play these from the first sample on. */
  static async open(context: BaseAudioContext, parts: Parts, set: Uint8Array, changes?: TimedChange[]): Promise<RigPlayer> {
    await context.audioWorklet.addModule(parts.worklet);
    const processorOptions: ProcessorOptions = { module: parts.module, set, ...(changes ? { changes } : {}) };
    const node = new AudioWorkletNode(context, 'rigsound', { numberOfInputs: 0, outputChannelCount: [2], processorOptions });
    const facts = await new Promise<Facts>((resolve, reject) => {
      node.port.onmessage = ({ data }: MessageEvent<FromEngine>) => {
        if (data.kind === 'ready') resolve(data);
        if (data.kind === 'failed') reject(new Error(data.error));
      };
      node.onprocessorerror = () => reject(new Error('the audio thread could not start the engine'));
    });
    const player = new RigPlayer(context, node, facts);
    node.port.onmessage = ({ data }: MessageEvent<FromEngine>) => player.hear(data);
    return player;
  }

  change(change: Change): void { this.say({ kind: 'change', change }); }
  /** `change` for one block of the rig, then `back`. */
  pulse(change: Change, back: Change): void { this.say({ kind: 'pulse', change, back }); }
  /** Resolves once the set plays, or cannot. The audio thread is busy with it: more than one at a time would silence it. */
  load(set: Uint8Array): Promise<void> {
    this.say({ kind: 'load', set });
    return new Promise((done) => { this.loading.push(done); });
  }
  play(changes: TimedChange[], fromFrame: number): void { this.say({ kind: 'play', changes, fromFrame }); }
  pause(): void { this.say({ kind: 'pause' }); }

  close(): void {
    this.say({ kind: 'end' });
    this.node.disconnect();
  }

  private say(message: ToEngine): void { this.node.port.postMessage(message); }

  private hear(message: FromEngine): void {
    if (message.kind === 'ready' || message.kind === 'failed') this.loading.shift()?.();
    if (message.kind === 'levels') this.onLevels(message);
    else if (message.kind !== 'ready') this.onProblem(message.error);
  }
}
