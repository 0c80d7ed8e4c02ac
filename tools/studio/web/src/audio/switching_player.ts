// Several sounds of equal length that run side by side, of which one is heard: switching keeps the place to the sample.
import { resume } from './output';

const kSwitch_s = 0.004, kLead_s = 0.02;

interface Lane { source: AudioBufferSourceNode; gain: GainNode }

export class SwitchingPlayer {
  private lanes = new Map<string, Lane>();
  private sounds = new Map<string, { buffer: AudioBuffer; level: number }>();
  private chosen = '';
  private began_s = 0;
  private from_s = 0;
  loop: { from_s: number; to_s: number } | null = null;
  onEnd: () => void = () => undefined;

  constructor(readonly context: AudioContext) {}

  /** `level`: factor that matches it with the others. */
  put(name: string, buffer: AudioBuffer, level = 1): void {
    this.sounds.set(name, { buffer, level });
    if (this.sounds.size === 1) this.chosen = name;
  }

  get playing(): boolean { return this.lanes.size > 0; }
  get heard(): string { return this.chosen; }
  get length_s(): number { return Math.max(0, ...[...this.sounds.values()].map(({ buffer }) => buffer.duration)); }

  /** Where in the sound we are. */
  position_s(): number {
    if (!this.playing) return this.from_s;
    const at = this.from_s + Math.max(0, this.context.currentTime - this.began_s);
    if (!this.loop || at < this.loop.to_s) return Math.min(at, this.length_s);
    const { from_s, to_s } = this.loop;
    return from_s + (at - from_s) % (to_s - from_s);
  }

  choose(name: string): void {
    this.chosen = name;
    // A fade that begins at once is cut short where the page is late: what is past counts as if it were now.
    const now = this.context.currentTime, begin = now + kLead_s;
    this.lanes.forEach(({ gain }, each) => {
      const held = gain.gain.value;
      gain.gain.cancelScheduledValues(now);
      gain.gain.setValueAtTime(held, now);
      gain.gain.setValueAtTime(held, begin);
      gain.gain.linearRampToValueAtTime(each === name ? this.sounds.get(each)?.level ?? 1 : 0, begin + kSwitch_s);
    });
  }

  play(from_s = this.from_s >= this.length_s - 0.01 ? 0 : this.from_s): void {
    this.halt();
    void resume();
    this.from_s = from_s;
    this.began_s = this.context.currentTime + kLead_s;
    this.sounds.forEach(({ buffer, level }, name) => {
      const source = new AudioBufferSourceNode(this.context, { buffer });
      const gain = new GainNode(this.context, { gain: name === this.chosen ? level : 0 });
      if (this.loop) Object.assign(source, { loop: true, loopStart: this.loop.from_s, loopEnd: this.loop.to_s });
      source.connect(gain).connect(this.context.destination);
      source.start(this.began_s, from_s);
      this.lanes.set(name, { source, gain });
      source.onended = () => {
        if (this.lanes.get(name)?.source !== source || name !== this.chosen) return;
        this.stop();
        this.from_s = 0;
        this.onEnd();
      };
    });
  }

  stop(): void {
    this.from_s = this.position_s();
    this.halt();
  }

  seek(to_s: number): void {
    if (this.playing) this.play(to_s);
    else this.from_s = to_s;
  }

  private halt(): void {
    this.lanes.forEach(({ source }) => { source.onended = null; source.stop(); source.disconnect(); });
    this.lanes.clear();
  }
}
