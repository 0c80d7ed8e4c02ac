// Steel: a bar of some length and diameter, the modes it wants and the modes the engine reaches, heard and saved.
import { h } from '../dom/element';
import { button, pick } from '../dom/fields';
import { editButtons } from '../edit/edit_buttons';
import { History } from '../edit/history';
import type { Rig, SoundSet } from '../server/documents';
import { newest } from '../server/newest';
import { askJson, ServerError } from '../server/request';
import type { Page } from '../shell/page';
import { hearPanel } from './hear_panel';
import { modesView } from './modes_view';
import { isFitted, nameOf, steelOf, type Mode, type Steel, type SteelRanges, type StoredTool } from './steel';
import { steelForm } from './steel_form';
import { openSteelSound } from './steel_sound';
import { ToolShelf } from './tool_shelf';

const kName = /^[A-Za-z0-9_-][A-Za-z0-9_.-]*$/;
const tune = (steel: Steel): Promise<{ modes: Mode[] }> => askJson('/steel', { method: 'POST', body: steel });

export const steelPage: Page = {
  id: 'steel', title: 'Steel', about: 'A bar, its modes, and how it rings',
  open: async (place, tools, state) => {
    const [sounds, rig, ranges] = await Promise.all([askJson<SoundSet>('/sound_set'), askJson<Rig>('/rig'), askJson<SteelRanges>('/steel')]);
    const first: Steel = { length_m: ranges.bar.length_m.value, diameter_m: ranges.bar.diameter_m.value, transversal: null, longitudinal: null };
    const history = new History<Steel>(first), shelf = new ToolShelf(sounds);
    const bank = sounds.uses.find(({ situation }) => situation === 'normal')?.bank ?? sounds.banks[0]?.name ?? '';
    const note = h('p', { class: 'note', role: 'status' });
    const wrong = (error: unknown): void => { note.textContent = error instanceof Error ? error.message : String(error); };
    let { modes } = await tune(first), moving = '', proposed = nameOf(first), heard = first, refused = false;
    const refuse = (error: unknown): void => { refused = true; wrong(error); };
    const sound = await openSteelSound(rig, first, sounds.banks.some(({ name }) => name === bank) ? bank : '', refuse);
    const view = modesView(), hear = hearPanel(sounds, bank, sound);
    const tuned = newest<Steel>(async (steel) => {
      ({ modes } = await tune(steel));
      view.show(modes);
      if (refused) note.textContent = '';
      refused = false;
    }, refuse);

    const turn = (part: Partial<Steel>, field: string): void => {
      history.set({ ...history.value, ...part }, moving === field);
      moving = field;
    };
    const form = steelForm(ranges, () => modes, turn);
    const name = h('input', { type: 'text', id: 'steel-name', value: proposed, autocomplete: 'off', spellcheck: 'false' });
    const show = (steel: Steel): void => {
      form.show(steel);
      edit.show();
      // The name follows the size until somebody gives one.
      if (name.value === proposed) name.value = nameOf(steel);
      proposed = nameOf(steel);
    };
    history.onChange = (steel) => {
      // What is heard first: it takes longest.
      if (steel !== heard) {
        sound.setSteel(steel);
        tuned.ask(steel);
      }
      heard = steel;
      show(steel);
    };

    const take = (stored: StoredTool): void => {
      moving = '';
      history.set(steelOf(stored));
      history.markSaved();
      name.value = stored.name;
    };
    const begin = async (wanted: string): Promise<void> => {
      try {
        if (!wanted) return turn(first, 'new');
        const stored = await shelf.read(wanted);
        take(stored);
        note.textContent = isFitted(stored) ? `${wanted} was fitted to a recording: saved under this name it rings by length, diameter and decay alone.` : '';
      } catch (error) { wrong(error); }
    };
    const from = pick('Begin with', [['', 'a new bar'], ...shelf.names.map((each) => [each, each] as const)], '', (wanted) => void begin(wanted));

    const bringBack = async (wanted: string): Promise<void> => {
      try {
        take(await shelf.restore(wanted));
        note.replaceChildren(`${wanted} is as it was before.`, button('Take that back', () => void bringBack(wanted)));
      } catch (error) { wrong(error); }
    };
    const save = async (): Promise<void> => {
      const wanted = name.value, saving = history.value;
      if (!kName.test(wanted)) return wrong(new Error('A name has letters, digits, _ - and . only, and does not begin with a point.'));
      try {
        const replaced = await shelf.save(wanted, saving);
        if (history.value === saving) history.markSaved();
        moving = '';
        note.replaceChildren(`Saved as ${wanted}. A [[boom]] takes it by tool = "${wanted}".`,
          ...(replaced ? [button('Bring the one before back', () => void bringBack(wanted))] : []));
      } catch (error) {
        if (!(error instanceof ServerError && error.status === 409)) return wrong(error);
        note.replaceChildren(`A tool named ${wanted} is there already, which this page has not shown.`, button('Take that one', () => void begin(wanted)),
          button('Replace it', () => { shelf.accept(wanted, String(error.answer.version)); void save(); }));
      }
    };
    const edit = editButtons(history, () => void save(), state.writable, () => true);
    tools.replaceChildren(h('label', { for: 'steel-name' }, 'Name'), name, ...edit.elements);
    // What is said stands below what is turned: nothing moves away under the pointer.
    place.replaceChildren(h('div', { class: 'columns bench' },
      h('div', { class: 'stack' }, h('section', { class: 'panel form', 'aria-label': 'Bar' }, shelf.names.length ? from.element : null, form.element), hear.element, note),
      view.picture), view.table);
    show(first);
    view.show(modes);
    return {
      shortcuts: [...hear.shortcuts, ...edit.shortcuts],
      unsaved: () => (history.changed ? 'The steel is not saved.' : null),
      close: () => { tuned.end(); sound.close(); view.close(); },
    };
  },
};
