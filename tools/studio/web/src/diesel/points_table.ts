// The speeds and loads at which a diesel was learned, and a way to each.
import { h } from '../dom/element';
import { button } from '../dom/fields';
import { shown } from '../dom/number_text';
import type { Point } from './diesel';

export const pointsTable = (points: Point[], go: (index: number) => void) => {
  const rows = points.map(({ rpm, load, source, recording }, n) => h('tr', {}, h('td', { class: 'n' }, shown(rpm)), h('td', { class: 'n' }, shown(load, 0.01)),
    h('td', {}, source, recording ? null : h('span', { class: 'quiet' }, ' (not here)')), h('td', {}, button('Set', () => go(n), { 'aria-label': `Set ${shown(rpm)} r/min, load ${shown(load, 0.01)}` }))));
  return {
    element: h('section', { class: 'panel', 'aria-label': 'Learned at' }, h('h3', {}, 'Learned at'), h('div', { class: 'parts', tabindex: 0, role: 'group', 'aria-label': 'Speeds and loads' },
      h('table', {}, h('thead', {}, h('tr', {}, h('th', { scope: 'col', class: 'n' }, 'r/min'), h('th', { scope: 'col', class: 'n' }, 'Load'), h('th', { scope: 'col' }, 'Recording'), h('th', {}, h('span', { class: 'unseen' }, 'Set')))),
        h('tbody', {}, ...rows)))),
    show: (point: number) => rows.forEach((each, n) => each.classList.toggle('selected', n === point)),
  };
};
