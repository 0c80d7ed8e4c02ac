// The one thing at a time that a listening test shows, with its keys.
import { h } from '../dom/element';
import { button } from '../dom/fields';
import type { Shortcut } from '../shell/shortcuts';
import { failed, loading } from '../shell/states';

export class Stage {
  readonly element = h('div', { class: 'trial stack' });
  /** Of what is shown; the same list as long as the page is open. */
  readonly shortcuts: Shortcut[] = [];

  /** Its heading gets the focus, so that it is read out and no button has the keys. */
  show(element: HTMLElement, shortcuts: Shortcut[] = []): void {
    this.shortcuts.splice(0, this.shortcuts.length, ...shortcuts);
    this.element.replaceChildren(element);
    const heading = element.querySelector('h2');
    heading?.setAttribute('tabindex', '-1');
    heading?.focus();
  }

  /** Words and one way on. */
  pause(title: string, words: string, on: string): Promise<void> {
    return new Promise((done) => {
      this.show(h('div', { class: 'panel stack' }, h('h2', {}, title), h('p', {}, words),
        h('div', { class: 'row' }, button(on, () => done(), { class: 'main', 'aria-keyshortcuts': 'Enter' }))),
      [{ key: 'Enter', does: on, run: () => done() }]);
    });
  }

  /** What `work` gives, however often it has to be begun; `words` while it is waited for. */
  async insist<T>(work: () => Promise<T>, words?: string): Promise<T> {
    for (;;) {
      if (words) this.show(loading(words));
      try {
        return await work();
      } catch (error) {
        await new Promise<void>((again) => {
          this.show(failed(error, again), [{ key: 'Enter', does: 'Try again', run: again }]);
        });
      }
    }
  }
}
