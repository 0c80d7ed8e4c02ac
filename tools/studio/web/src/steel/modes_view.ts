// The modes that a bar wants and those that its loop reaches: a picture and a table.
import { plot, scaleOf } from '../chart/plot';
import { h } from '../dom/element';
import { shown } from '../dom/number_text';
import { families, type Mode } from './steel';

const kFrom_hz = 100, kTo_hz = 20000;
const kHeads = ['Mode', 'Wanted, Hz', 'Reached, Hz', 'Off by, cents', 'Falls by 60 dB in, s'];

const row = (mode: Mode): HTMLElement => h('tr', {}, h('td', { class: 'n' }, mode.mode), h('td', { class: 'n' }, shown(mode.target_hz, 0.1)),
  h('td', { class: 'n' }, shown(mode.model_hz, 0.1)), h('td', { class: 'n' }, shown(mode.error_cents, 0.01)), h('td', { class: 'n' }, shown(mode.t60_s, 0.001)));

export const modesView = () => {
  const picture = plot('Modes of the bar', 'A stem is a wanted mode, a dot the mode that is reached; its height is the time to fall by 60 dB.');
  const bodies = families.map(() => h('tbody', {}));
  const tables = families.map(({ words }, n) => h('section', { class: 'panel wide', 'aria-label': `${words} modes` }, h('h3', {}, words),
    h('div', { class: 'modes', tabindex: 0, role: 'group', 'aria-label': `${words} modes, all of them` },
      h('table', {}, h('thead', {}, h('tr', {}, ...kHeads.map((head) => h('th', { scope: 'col', class: 'n' }, head)))), bodies[n]))));
  return {
    picture: picture.element, table: h('div', { class: 'columns two' }, ...tables),
    show: (modes: Mode[]) => {
      picture.show({ x: { from: kFrom_hz, to: kTo_hz, log: true, unit: 'Hz' }, y: scaleOf(modes.map(({ t60_s }) => t60_s), 's', { zero: true }),
        series: [{ name: 'wanted', colour: 'second', kind: 'stems', points: modes.map(({ target_hz, t60_s }) => [target_hz, t60_s] as const) },
          ...families.map(({ family, words }, n) => ({ name: `reached, ${words.toLowerCase()}`, colour: n ? 'third' as const : 'first' as const, kind: 'dots' as const,
            points: modes.filter((mode) => mode.family === family).map(({ model_hz, t60_s }) => [model_hz, t60_s] as const) }))] });
      families.forEach(({ family }, n) => bodies[n]?.replaceChildren(...modes.filter((mode) => mode.family === family).map(row)));
    },
    close: picture.close,
  };
};
