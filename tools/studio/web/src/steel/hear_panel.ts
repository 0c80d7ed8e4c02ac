// How a steel is struck: buttons, and whose impacts.
import { h } from '../dom/element';
import { button, pick, tick } from '../dom/fields';
import type { SoundSet } from '../server/documents';
import type { Shortcut } from '../shell/shortcuts';

interface Sound { setBank(name: string): void; setClicks(heard: boolean): void; blow(): void; drill(wanted: boolean): void }

export const hearPanel = (sounds: SoundSet, bank: string, sound: Sound) => {
  let drilling = false;
  const toggle = (): void => {
    drilling = !drilling;
    drill.textContent = drilling ? 'Stop' : 'Drill';
    blow.disabled = drilling;
    sound.drill(drilling);
  };
  const blow = button('One blow', () => sound.blow(), { 'aria-keyshortcuts': 'b' });
  const drill = button('Drill', toggle, { class: 'main play', 'aria-keyshortcuts': 'Space' });
  const banks = sounds.banks.length === 0 ? [] : [
    pick('Impacts of', [...sounds.banks.map((each) => [each.name, each.name] as const), ['', '24 a second, even'] as const], bank, sound.setBank).element,
    tick('With the clicks of the bank', false, sound.setClicks).element];
  const shortcuts: Shortcut[] = [{ key: ' ', does: 'Drill, stop', run: toggle }, { key: 'b', does: 'One blow', run: () => { if (!blow.disabled) sound.blow(); } }];
  return { element: h('section', { class: 'panel form', 'aria-label': 'Hear it' }, h('div', { class: 'row' }, drill, blow), ...banks), shortcuts };
};
