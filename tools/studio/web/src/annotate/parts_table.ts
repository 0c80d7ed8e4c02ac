// The labelled parts as a table, one of which is selected.
import { h } from '../dom/element';
import { clock } from '../dom/number_text';
import { situationWords } from '../rig/situation_words';
import type { Part } from './part';

const kHeads = ['From', 'To', 'Situation', 'Rods', 'Rock', 'Diesel', 'Feed', ''];

export const partsTable = (select: (index: number) => void, remove: (index: number) => void) => {
  const rows = h('tbody', {}), none = h('p', { class: 'quiet' }, 'No parts yet: drag over the picture, press n, or let parts be suggested.');
  const table = h('table', {}, h('thead', {}, h('tr', {}, ...kHeads.map((words) => h('th', { scope: 'col' }, words || h('span', { class: 'unseen' }, 'Remove'))))), rows);
  return {
    element: h('div', { class: 'parts wide', tabindex: 0, role: 'group', 'aria-label': 'Labelled parts' }, none, table),
    show: (parts: readonly Part[], selected: number) => {
      none.hidden = parts.length > 0;
      table.hidden = parts.length === 0;
      rows.replaceChildren(...parts.map((part, n) => {
        const choose = h('button', { type: 'button', class: 'link', 'aria-label': `${clock(part.from_s, 2)}: select part ${n + 1}, ${situationWords(part.situation)}` }, clock(part.from_s, 2));
        choose.addEventListener('click', () => select(n));
        const gone = h('button', { type: 'button', 'aria-label': `Remove part ${n + 1}` }, 'Remove');
        gone.addEventListener('click', () => remove(n));
        return h('tr', n === selected ? { class: 'selected', 'aria-current': 'true' } : {}, h('td', {}, choose), h('td', {}, clock(part.to_s, 2)),
          h('td', {}, h('span', { class: `swatch is-${part.situation}` }), situationWords(part.situation)), h('td', {}, part.rods ?? '–'), h('td', {}, part.rock ?? '–'),
          h('td', {}, part.rpm === null ? '–' : `${part.rpm} r/min`), h('td', {}, part.feed === null ? '–' : `${part.feed} bar`), h('td', { class: 'n' }, gone));
      }));
    },
  };
};
