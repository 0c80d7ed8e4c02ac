// Tiles of a recording: fetched when a picture wants them, coarser ones shown until they are there.
import type { Recording } from '../server/documents';
import { ask } from '../server/request';

const kColumns = 1024, kFrames = 64, kMostLevel = 20, kMost = 240, kAgain_ms = 1000;

export interface Tile<T> { level: number; index: number; content: T | null; exact: boolean; loading: boolean }

export class Tiles<T> {
  private readonly known = new Map<string, Tile<T>>();
  private closed = false;
  onArrival: () => void = () => undefined;

  /** `path(level, tile)` below the recording; `read` makes what is drawn of an answer. */
  constructor(private readonly recording: Recording, private readonly path: (level: number, tile: number) => string,
    private readonly read: (response: Response) => Promise<T>) {}

  /** The coarsest level that still has a column for every point of the screen. */
  levelFor(frames: number, points: number): number {
    return Math.max(0, Math.min(kMostLevel, Math.floor(Math.log2(Math.max(1, frames / points / kFrames)))));
  }

  span_s(level: number): number { return kColumns * kFrames * 2 ** level / this.recording.rate; }
  column_s(level: number): number { return this.span_s(level) / kColumns; }

  /** The tile, or what coarser one covers its place for now. */
  at(level: number, index: number): Tile<T> | null {
    const wanted = this.want(level, index);
    if (wanted.content) return wanted;
    for (let up = level + 1, at = index >> 1; up <= kMostLevel; ++up, at >>= 1) {
      const coarse = this.known.get(`${up}/${at}`);
      if (coarse?.content) return coarse;
    }
    return null;
  }

  close(): void { this.closed = true; }

  private want(level: number, index: number): Tile<T> {
    const key = `${level}/${index}`;
    let tile = this.known.get(key);
    if (!tile) this.known.set(key, tile = { level, index, content: null, exact: false, loading: false });
    else this.known.delete(key), this.known.set(key, tile);
    if (!tile.exact && !tile.loading) void this.load(tile);
    if (this.known.size > kMost) this.known.delete(this.known.keys().next().value as string);
    return tile;
  }

  private async load(tile: Tile<T>): Promise<void> {
    tile.loading = true;
    try {
      const response = await ask(`/recordings/${this.recording.id}/${this.path(tile.level, tile.index)}?v=${this.recording.hash}`);
      tile.exact = response.headers.get('X-Rigsound-Exact') !== '0';
      tile.content = await this.read(response);
    } catch { /* the next picture asks again; what is offline is said elsewhere */ }
    if (this.closed) return;
    if (tile.content) this.onArrival();
    if (tile.exact) tile.loading = false;
    else setTimeout(() => { tile.loading = false; if (!this.closed) this.onArrival(); }, kAgain_ms);
  }
}
