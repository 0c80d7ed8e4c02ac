// The part of a page that works on one of several things: another is opened when it is chosen, and nothing unsaved goes
// unasked.
import { h } from '../dom/element';
import type { Opened } from './page';
import type { Shortcut } from './shortcuts';
import { failed, loading } from './states';

export interface WorkFrame {
  /** Where the thing is worked on, and the buttons that go with it. */
  readonly work: HTMLElement;
  readonly actions: HTMLElement;
  /** What is chosen again while it is on its way is opened once. */
  show(id: string): Promise<void>;
  /** For the page to give back; its shortcuts are those of what is open. */
  readonly opened: Opened;
}

/** `words`: while it loads. `shown` is told which thing it is, also when a person rather stays. */
export const workFrame = (words: string, open: (id: string, place: HTMLElement, tools: HTMLElement) => Promise<Opened>, shown: (id: string) => void): WorkFrame => {
  const work = h('div', { class: 'stack' }), actions = h('div', { class: 'row' }), shortcuts: Shortcut[] = [];
  let now: Opened | null = null, turn = 0, here = '', onItsWay = '';
  const put = (made: Opened | null, place: HTMLElement, tools: HTMLElement | null): void => {
    now = made;
    work.replaceChildren(place);
    actions.replaceChildren(...(tools ? [tools] : []));
    shortcuts.splice(0, shortcuts.length, ...(made?.shortcuts ?? []));
  };
  const show = async (id: string): Promise<void> => {
    if (id === onItsWay) return;
    const lost = now?.unsaved?.();
    if (lost && !confirm(`${lost} Leave all the same?`)) return shown(here);
    const mine = ++turn;
    shown(here = onItsWay = id);
    now?.close();
    put(null, loading(words), null);
    try {
      // Another one may be chosen before this one is there.
      const place = h('div', { class: 'stack' }), tools = h('div', { class: 'row' }), made = await open(id, place, tools);
      if (mine !== turn) return made.close();
      put(made, place, tools);
    } catch (error) {
      if (mine === turn) put(null, failed(error, () => void show(id)), null);
    } finally {
      if (mine === turn) onItsWay = '';
    }
  };
  return { work, actions, show, opened: { shortcuts, unsaved: () => now?.unsaved?.() ?? null, close: () => { ++turn; now?.close(); } } };
};
