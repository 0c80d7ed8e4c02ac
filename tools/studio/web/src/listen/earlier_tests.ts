// Results that were saved with the sound set, one or several together.
import { h } from '../dom/element';
import { button, tick } from '../dom/fields';
import { ask, askJson } from '../server/request';
import { answersOf, type Answer } from './answers';

/** Null where there are none. */
export const earlierTests = async (show: (answers: Answer[]) => void): Promise<HTMLElement | null> => {
  const { results } = await askJson<{ results: { name: string; bytes: number }[] }>('/listen/results');
  if (results.length === 0) return null;
  const chosen = new Set<string>(), note = h('p', { class: 'note', role: 'status' });
  const read = async (): Promise<void> => {
    note.textContent = '';
    try {
      const each = await Promise.all([...chosen].map(async (name) => {
        try {
          return answersOf(await (await ask(`/listen/results/${name}`)).text());
        } catch (error) {
          throw new Error(`${name}: ${error instanceof Error ? error.message : String(error)}`);
        }
      }));
      show(each.flat());
    } catch (error) { note.textContent = (error as Error).message; }
  };
  const together = button('Show results', () => void read(), { disabled: true });
  return h('section', { class: 'panel form', 'aria-label': 'Earlier tests' }, h('h2', {}, 'Earlier tests'),
    h('fieldset', { class: 'label-form plain names' }, h('legend', { class: 'unseen' }, 'Earlier tests'), ...[...results].reverse().map(({ name }) => tick(name.replace(/\.csv$/, ''), false, (on) => {
      if (on) chosen.add(name);
      else chosen.delete(name);
      together.disabled = chosen.size === 0;
    }).element)), note, h('div', { class: 'row' }, together));
};
