// What a page of the studio is.
import type { State } from '../server/documents';
import type { Shortcut } from './shortcuts';

export interface Opened {
  /** Keys of this page, shown by `?`. */
  shortcuts?: Shortcut[];
  /** Ends what the page began: sound, timers, streams. */
  close(): void;
  /** Whether something would be lost; the words say what. */
  unsaved?(): string | null;
}

export interface Page {
  id: string;
  title: string;
  /** One line below the title. */
  about: string;
  /** Fills `place`; `tools` is the right end of the title's row. Rejections are shown in the page's place. */
  open(place: HTMLElement, tools: HTMLElement, state: State): Promise<Opened>;
}
