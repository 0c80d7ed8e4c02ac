// Plays a recording of any length in pieces that follow one another to the sample, or one part round and round.
import { fileContext, loadSound } from '../audio/sound_files';
import { resume } from '../audio/output';
import type { Recording } from '../server/documents';

const kPiece_s = 20, kAhead_s = 8, kLead_s = 0.03;

export class RecordingPlayer {
  private sources: AudioBufferSourceNode[] = [];
  private turn = 0;
  private began = 0;
  private from_s = 0;
  private length_s: number | null = null;
  private context: AudioContext | null = null;
  playing = false;
  onEnd: () => void = () => undefined;

  constructor(private readonly recording: Recording) {}

  /** Where we are, or null in silence. */
  position_s(): number | null {
    if (!this.playing || !this.context || this.began === 0) return null;
    const past = Math.max(0, this.context.currentTime - this.began);
    return this.from_s + (this.length_s ? past % this.length_s : past);
  }

  /** From there to the end, or with `loop_to_s` round and round. Rejects when the sound does not come. */
  async play(from_s: number, loop_to_s: number | null): Promise<void> {
    this.stop();
    const mine = ++this.turn;
    this.playing = true;
    this.from_s = from_s;
    this.length_s = loop_to_s === null ? null : Math.min(60, loop_to_s - from_s);
    const context = this.context = await fileContext();
    await resume();
    let buffer = await this.piece(from_s, this.length_s ?? kPiece_s);
    if (mine !== this.turn) return;
    this.began = context.currentTime + kLead_s;
    if (this.length_s) {
      this.start(buffer, this.began, true);
      return;
    }
    for (let at = from_s, when = this.began; ;) {
      this.start(buffer, when, false);
      when += buffer.duration;
      at += kPiece_s;
      if (at >= this.recording.seconds) {
        await this.until(when);
        if (mine === this.turn) this.stop(), this.onEnd();
        return;
      }
      await this.until(when - kAhead_s);
      if (mine !== this.turn) return;
      buffer = await this.piece(at, kPiece_s);
      if (mine !== this.turn) return;
    }
  }

  stop(): void {
    ++this.turn;
    this.playing = false;
    this.began = 0;
    this.sources.forEach((source) => { source.stop(); source.disconnect(); });
    this.sources = [];
  }

  private piece(from_s: number, length_s: number): Promise<AudioBuffer> {
    return loadSound(`/recordings/${this.recording.id}/audio?from=${from_s}&to=${Math.min(this.recording.seconds, from_s + length_s)}`);
  }

  private start(buffer: AudioBuffer, when: number, loop: boolean): void {
    const source = new AudioBufferSourceNode(this.context as AudioContext, { buffer, loop });
    source.connect((this.context as AudioContext).destination);
    source.start(when);
    this.sources = [...this.sources.slice(-1), source];
  }

  private until(when: number): Promise<void> {
    return new Promise((done) => setTimeout(done, Math.max(0, 1000 * (when - (this.context as AudioContext).currentTime))));
  }
}
