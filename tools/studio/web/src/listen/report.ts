// What a listening test has shown, and its CSV.
import { h } from '../dom/element';
import { shown } from '../dom/number_text';
import { abxFigures, csvOf, isScreenedOut, ratingFigures, type Answer } from './results';

const probability = (p: number): string => (p < 0.001 ? 'under 0.001' : shown(p, 0.001));

export const report = (answers: readonly Answer[]): HTMLElement => {
  const csv = URL.createObjectURL(new Blob([csvOf(answers)], { type: 'text/csv' }));
  const link = h('a', { href: csv, download: 'listening.csv', class: 'button' }, 'Download CSV');
  if (answers[0]?.test === 'abx') {
    const { right, of, p } = abxFigures(answers);
    return h('div', { class: 'panel stack' }, h('h2', {}, `${right} of ${of} right`),
      h('p', {}, `Probability of at least as many by guessing: ${probability(p)} (exact binomial test, one-sided). `,
        p < 0.05 ? 'The two sounds were told apart.' : 'That the two sounds can be told apart is not shown.'), h('p', {}, link));
  }
  return h('div', { class: 'panel stack' }, h('h2', {}, 'Ratings'), h('table', {}, h('thead', {}, h('tr', {}, ...['Sound', 'Ratings', 'Median', '95 % interval of the median'].map((words) => h('th', { scope: 'col' }, words)))),
    h('tbody', {}, ...ratingFigures(answers).map((row) => h('tr', {}, h('td', {}, row.sound), h('td', {}, row.count), h('td', {}, shown(row.median, 0.5)),
      h('td', {}, row.interval ? `${row.interval[0]} to ${row.interval[1]}` : 'needs six ratings at least'))))),
  isScreenedOut(answers) ? h('p', { class: 'note' }, 'The hidden reference was rated under 90 in more than 15 % of the trials: BS.1534 leaves such a listener out.') : null, h('p', {}, link));
};
