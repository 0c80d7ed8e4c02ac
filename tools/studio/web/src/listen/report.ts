// What listening tests have shown, and its CSV.
import { h, svg } from '../dom/element';
import { shown } from '../dom/number_text';
import { csvOf, type Answer } from './answers';
import { abxFigures, figuresCsv, ratingFigures, screenedOut, type AbxFigures, type RatingFigures } from './figures';
import { leastShown } from './statistics';

const probability = (p: number): string => (p < 0.001 ? 'under 0.001' : shown(p, 0.001));

const download = (words: string, name: string, csv: string): HTMLElement =>
  h('a', { href: URL.createObjectURL(new Blob([csv], { type: 'text/csv' })), download: name, class: 'button' }, words);

const abxPanel = ({ pair, right, of, p }: AbxFigures): HTMLElement => {
  const least = leastShown(of);
  return h('section', { class: 'panel stack', 'aria-label': pair }, h('h2', {}, `${right} of ${of} right`), h('p', { class: 'quiet' }, `X against A and B: ${pair}`),
    h('p', {}, `Probability of at least as many by guessing: ${probability(p)} (exact binomial test, one-sided). `,
      p < 0.05 ? 'The two sounds were told apart.' : 'That the two sounds can be told apart is not shown.',
      least === null ? ' No result of so few trials could show it.' : p < 0.05 ? '' : ` That would take ${least} of ${of}.`));
};

/** Median and interval on the scale of 0 to 100. */
const intervalPicture = ({ median, interval, sound }: RatingFigures): SVGElement => svg('svg', { class: 'interval', viewBox: '0 0 200 16', role: 'img', 'aria-label': `${sound}: median and interval on the scale` },
  ...[0, 20, 40, 60, 80, 100].map((score) => svg('line', { class: 'tick-mark', x1: 2 * score, x2: 2 * score, y1: 2, y2: 14 })),
  ...(interval ? [svg('line', { class: 'range', x1: 2 * interval[0], x2: 2 * interval[1], y1: 8, y2: 8 })] : []), svg('circle', { cx: 2 * median, cy: 8, r: 4 }));

const ratingPanel = (rows: RatingFigures[], out: string[]): HTMLElement => h('section', { class: 'panel stack', 'aria-label': 'Ratings' }, h('h2', {}, 'Ratings'),
  h('div', { class: 'wide' }, h('table', {}, h('thead', {}, h('tr', {}, ...['Sound', 'Ratings', 'Median', '95 % interval of the median', 'Bad to excellent'].map((words, n) => h('th', { scope: 'col', class: n === 1 || n === 2 ? 'n' : '' }, words)))),
    h('tbody', {}, ...rows.map((row) => h('tr', {}, h('th', { scope: 'row' }, row.sound), h('td', { class: 'n' }, row.count), h('td', { class: 'n' }, shown(row.median, 0.5)),
      h('td', {}, row.interval ? `${row.interval[0]} to ${row.interval[1]}` : 'needs six ratings at least'), h('td', {}, intervalPicture(row))))))),
  out.length ? h('p', { class: 'note' }, `The hidden reference was rated under 90 in more than 15 % of the trials by ${out.map((name) => name || 'a listener without a name').join(', ')}: BS.1534 leaves such a listener out.`) : null);

export const report = (answers: readonly Answer[]): HTMLElement => {
  const abx = abxFigures(answers), rated = ratingFigures(answers);
  return h('div', { class: 'stack' }, ...abx.map(abxPanel), rated.length ? ratingPanel(rated, screenedOut(answers)) : null,
    h('div', { class: 'row' }, download('Download answers', 'listening.csv', csvOf(answers)), download('Download figures', 'listening_figures.csv', figuresCsv(answers))));
};
