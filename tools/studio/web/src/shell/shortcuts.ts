// Keys of the page, and the list of them.
import { button } from '../dom/fields';
import { h } from '../dom/element';

export interface Shortcut {
  /** As KeyboardEvent.key has it, with "Control+" in front where that is meant. */
  key: string;
  does: string;
  run(): void;
}

const kShown: Record<string, string> = { ' ': 'Space', ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓', Delete: 'Del' };
const shownKey = (key: string): string[] => key.split(/(?<=.)\+(?=.)/).map((part) => kShown[part] ?? (part === 'Control' ? 'Ctrl' : part));

/** Fields keep the keys that they need themselves. */
const isWanted = (target: EventTarget | null, key: string): boolean => {
  if (!(target instanceof HTMLElement) || key.startsWith('Control+') || key === 'Escape') return false;
  if (target instanceof HTMLInputElement && target.type === 'range') return /^(Arrow|Home|End|Page)/.test(key);
  if (target instanceof HTMLInputElement && target.type === 'radio') return /^Arrow| /.test(key);
  if (target instanceof HTMLInputElement && target.type === 'checkbox') return key === ' ';
  if (target.matches('button, a, summary')) return key === ' ' || key === 'Enter';
  return target.matches('input, select, textarea');
};

export class Shortcuts {
  private page: Shortcut[] = [];

  constructor(private readonly everywhere: Shortcut[]) {
    everywhere.push({ key: '?', does: 'Show these keys', run: () => this.show() });
    addEventListener('keydown', (event) => this.press(event));
  }

  ofPage(shortcuts: Shortcut[]): void { this.page = shortcuts; }

  private press(event: KeyboardEvent): void {
    const key = (event.ctrlKey || event.metaKey ? 'Control+' : '') + event.key;
    if (event.altKey || document.querySelector('dialog[open]') || isWanted(event.target, key)) return;
    const found = [...this.page, ...this.everywhere].find((shortcut) => shortcut.key === key);
    if (!found) return;
    event.preventDefault();
    found.run();
  }

  show(): void {
    const rows = (shortcuts: Shortcut[]): HTMLElement => h('div', { class: 'keys' }, ...shortcuts.map(({ key, does }) =>
      h('div', {}, does, h('span', {}, ...shownKey(key).map((part) => h('kbd', {}, part))))));
    const dialog = h('dialog', { 'aria-label': 'Keyboard' }, h('h2', {}, 'Keyboard'),
      ...(this.page.length ? [h('h3', {}, 'This page'), rows(this.page)] : []), h('h3', {}, 'Everywhere'), rows(this.everywhere),
      h('p', { class: 'row' }, button('Close', () => dialog.close())));
    dialog.addEventListener('close', () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  }
}
