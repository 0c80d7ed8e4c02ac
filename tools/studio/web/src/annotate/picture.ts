// The recording on the screen: outline and spectrogram from tiles, parts over both, cursor and place that is heard.
import { Surface } from '../chart/surface';
import { shown } from '../dom/number_text';
import type { Recording } from '../server/documents';
import { partWords, type Part, type Suggestion } from './part';
import { Tiles } from './tiles';
import type { ViewRange } from './view_range';

export interface Marks { parts: readonly Part[]; selected: number; suggestions: readonly Suggestion[]; suggested: number; cursor_s: number; heard_s: number | null }

const kLow_hz = 80, kHigh_hz = 18000;

export class Picture {
  readonly wave = new Surface('Outline of the recording', { left: 56, right: 12, top: 20, bottom: 4 });
  readonly sonagram = new Surface('Spectrogram of the recording, 80 Hz to 18 kHz', { left: 56, right: 12, top: 2, bottom: 26 });
  private readonly peaks: Tiles<Int8Array>;
  private readonly images: Tiles<ImageBitmap>;
  private wanted = false;
  private closed = false;
  range: ViewRange;
  marks: Marks = { parts: [], selected: -1, suggestions: [], suggested: -1, cursor_s: 0, heard_s: null };

  constructor(private readonly recording: Recording) {
    this.range = { from_s: 0, to_s: recording.seconds };
    this.peaks = new Tiles(recording, (level, tile) => `peaks/${level}/${tile}`, async (response) => new Int8Array(await response.arrayBuffer()));
    this.images = new Tiles(recording, (level, tile) => `spectrogram/${level}/${tile}.png`, async (response) => createImageBitmap(await response.blob()));
    this.peaks.onArrival = this.images.onArrival = this.wave.onResize = this.sonagram.onResize = () => this.draw();
    this.wave.element.classList.add('wave');
    this.sonagram.element.classList.add('sonagram');
  }

  /** Once before the next frame, however often it is asked for. */
  draw(): void {
    if (this.wanted || this.closed) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      if (this.closed) return;
      this.drawWave();
      this.drawSonagram();
    });
  }

  timeAt(offsetX: number): number { return Math.max(0, Math.min(this.recording.seconds, this.wave.valueAt(offsetX))); }
  /** Seconds of `points` of the screen. */
  width_s(points: number): number { return points * (this.range.to_s - this.range.from_s) / this.wave.inner.width; }

  private visible<T>(tiles: Tiles<T>, width: number, use: (content: T, start_s: number, column_s: number, from_s: number, to_s: number) => void): void {
    const { from_s, to_s } = this.range;
    const level = tiles.levelFor((to_s - from_s) * this.recording.rate, width), span = tiles.span_s(level);
    for (let index = Math.floor(from_s / span); index * span < Math.min(to_s, this.recording.seconds); ++index) {
      const tile = tiles.at(level, index);
      if (tile?.content)
        use(tile.content, tile.index * tiles.span_s(tile.level), tiles.column_s(tile.level), Math.max(from_s, index * span), Math.min(to_s, (index + 1) * span));
    }
  }

  private drawWave(): void {
    const { wave, range } = this, { paint, inner } = wave;
    wave.start({ x: { from: range.from_s, to: range.to_s, unit: 's', time: true }, y: { from: -1, to: 1, unit: '', words: [] } });
    paint.fillStyle = wave.colour('edge');
    const middle = inner.y + inner.height / 2, half = inner.height / 2 / 127;
    this.visible(this.peaks, inner.width, (peaks, start, column, from, to) => {
      for (let x = Math.floor(wave.x(from)); x < wave.x(to); ++x) {
        const first = Math.max(0, Math.floor((wave.valueAt(x) - start) / column)), last = Math.max(first + 1, Math.ceil((wave.valueAt(x + 1) - start) / column));
        let low = 0, high = 0;
        for (let n = first; n < last && n < 1024; ++n) {
          low = Math.min(low, peaks[2 * n] ?? 0);
          high = Math.max(high, peaks[2 * n + 1] ?? 0);
        }
        paint.fillRect(x, middle - high * half, 1, Math.max(1, (high - low) * half));
      }
    });
    this.drawParts(wave, true);
  }

  private drawSonagram(): void {
    const { sonagram, range } = this, { paint, inner } = sonagram;
    const y = { from: kLow_hz, to: kHigh_hz, log: true, unit: '' };
    sonagram.start({ x: { from: range.from_s, to: range.to_s, unit: 's', time: true }, y });
    paint.imageSmoothingEnabled = false;
    this.visible(this.images, inner.width, (image, start, column, from, to) => {
      const first = (from - start) / column, last = (to - start) / column;
      paint.drawImage(image, first, 0, Math.max(0.01, last - first), image.height, sonagram.x(from), inner.y, sonagram.x(to) - sonagram.x(from), inner.height);
    });
    this.drawParts(sonagram, false);
  }

  private drawParts(surface: Surface, named: boolean): void {
    const { paint, inner } = surface, { marks } = this;
    paint.save();
    paint.beginPath();
    paint.rect(inner.x, 0, inner.width, inner.y + inner.height);
    paint.clip();
    marks.suggestions.forEach((suggestion, n) => {
      paint.setLineDash([5, 4]);
      paint.lineWidth = n === marks.suggested ? 2 : 1;
      paint.strokeStyle = surface.colour('first');
      const left = surface.x(suggestion.from_s), right = surface.x(suggestion.to_s);
      paint.strokeRect(left + 1, inner.y + 1, right - left - 2, inner.height - 2);
      if (named && right - left > 60) this.name(surface, `${shown(100 * suggestion.rhythmic)} % rhythmic`, left, right, 'first', inner.y + inner.height - 10);
      if (n === marks.suggested) surface.bar(suggestion.from_s, suggestion.to_s, surface === this.wave ? -1 : kLow_hz, surface === this.wave ? 1 : kHigh_hz, 'first', 0.15);
    });
    paint.setLineDash([]);
    marks.parts.forEach((part, n) => {
      const left = surface.x(part.from_s), right = surface.x(part.to_s), chosen = n === marks.selected;
      paint.globalAlpha = named ? 0.28 : 0.1;
      paint.fillStyle = surface.colour(part.situation);
      paint.fillRect(left, named ? 0 : inner.y, right - left, inner.y + inner.height);
      paint.globalAlpha = 1;
      paint.strokeStyle = surface.colour(chosen ? 'ink' : part.situation);
      paint.lineWidth = chosen ? 2 : 1.5;
      paint.strokeRect(left, named ? 1 : inner.y, right - left, inner.y + inner.height);
      if (named && right - left > 24) this.name(surface, partWords(part), left, right, 'ink');
    });
    const line = (at_s: number, colour: string, width: number): void => {
      paint.fillStyle = surface.colour(colour);
      paint.fillRect(surface.x(at_s) - width / 2, 0, width, inner.y + inner.height);
    };
    line(marks.cursor_s, 'first', 1.5);
    if (marks.heard_s !== null) line(marks.heard_s, 'third', 2);
    paint.restore();
  }

  private name(surface: Surface, words: string, left: number, right: number, colour: string, y = surface.inner.y / 2 + 1): void {
    const { paint, inner } = surface;
    paint.save();
    paint.beginPath();
    paint.rect(Math.max(inner.x, left), 0, right - Math.max(inner.x, left) - 3, inner.y + inner.height);
    paint.clip();
    paint.fillStyle = surface.colour(colour);
    paint.textAlign = 'left';
    paint.textBaseline = 'middle';
    paint.fillText(words, Math.max(inner.x, left) + 5, y);
    paint.restore();
  }

  close(): void {
    this.closed = true;
    this.peaks.close();
    this.images.close();
    this.wave.close();
    this.sonagram.close();
  }
}
