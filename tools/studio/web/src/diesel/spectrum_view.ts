// A diesel's spectrum with its orders, beside the recording where there is one, and the loudest orders as a table.
import { plot, type Series } from '../chart/plot';
import { h } from '../dom/element';
import { shown } from '../dom/number_text';
import type { Lines, Order, Spectrum } from './diesel';

// The scales stand still while the speed moves.
const kX = { from: 20, to: 10000, log: true, unit: 'Hz' }, kY = { from: -120, to: -20, unit: 'dB' };
const kLoudest = 6;

const points = ({ hz, db }: Lines): [number, number][] => hz.map((x, n) => [x, db[n] ?? kY.from]);
const row = ({ order, hz, db }: Order): HTMLElement =>
  h('tr', {}, h('td', { class: 'n' }, shown(order, 0.1)), h('td', { class: 'n' }, shown(hz, 0.1)), h('td', { class: 'n' }, shown(db, 0.1)));

export const spectrumView = () => {
  const picture = plot('Spectrum', 'Power in bands of 1/8 order of the cycle, re full scale. Stems are the orders: halves and whole multiples of the turns a second.');
  picture.element.classList.add('tall');
  const rows = h('tbody', {});
  const table = h('section', { class: 'panel', 'aria-label': 'Loudest orders' }, h('h3', {}, 'Loudest orders'),
    h('table', {}, h('thead', {}, h('tr', {}, ...['Order', 'Hz', 'dB'].map((words) => h('th', { scope: 'col', class: 'n' }, words)))), rows));
  return {
    picture: picture.element, table,
    show: (model: Spectrum, recorded: Spectrum | null) => {
      const series: Series[] = [...(recorded ? [{ name: `recorded at ${shown(recorded.rpm)} r/min`, colour: 'second' as const, points: points(recorded.spectrum) }] : []),
        { name: `model at ${shown(model.rpm)} r/min`, colour: 'first', points: points(model.spectrum) },
        { name: 'orders', colour: 'third', kind: 'stems', points: model.orders.map(({ hz, db }) => [hz, db] as const) }];
      picture.show({ x: kX, y: kY, series });
      rows.replaceChildren(...[...model.orders].sort((a, b) => b.db - a.db).slice(0, kLoudest).map(row));
    },
    close: picture.close,
  };
};
