// The bars of the sound set: read, saved by the version that was last seen, brought back.
import type { SoundSet } from '../server/documents';
import { askJson } from '../server/request';
import type { Steel, StoredTool } from './steel';

const pathOf = (name: string): string => `/tools/${encodeURIComponent(name)}`;

/** Requests reject as askJson does; 409 when a tool is another one than was seen. */
export class ToolShelf {
  private readonly versions: Map<string, string>;

  constructor({ tools }: SoundSet) {
    this.versions = new Map(tools.filter(({ kind }) => kind === 'bar').map(({ name, version }) => [name, version]));
  }

  get names(): string[] { return [...this.versions.keys()]; }

  async read(name: string): Promise<StoredTool> {
    const stored = await askJson<StoredTool>(pathOf(name));
    this.versions.set(name, stored.version);
    return stored;
  }

  /** Whether it took the place of another one, which restore() brings back. */
  async save(name: string, steel: Steel): Promise<boolean> {
    const before = this.versions.get(name);
    const { version } = await askJson<{ version: string }>(pathOf(name), { method: 'PUT', body: { ...steel, version: before ?? 'absent' } });
    this.versions.set(name, version);
    return before !== undefined && before !== version;
  }

  /** Twice is as if never. */
  async restore(name: string): Promise<StoredTool> {
    await askJson(`${pathOf(name)}/restore`, { method: 'POST', body: { version: this.versions.get(name) ?? 'absent' } });
    return this.read(name);
  }

  /** A version that was not seen may be replaced. */
  accept(name: string, version: string): void { this.versions.set(name, version); }
}
