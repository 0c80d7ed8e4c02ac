// What the answers of listening tests add up to.
import { csvRows, type Answer } from './answers';
import type { Kind } from './blind_trial';
import { guessing, median, medianInterval } from './statistics';

export interface AbxFigures { pair: string; right: number; of: number; p: number }
export interface RatingFigures { sound: Kind; count: number; median: number; interval: [number, number] | null }

const counted = (answers: readonly Answer[], test: Answer['test']): Answer[] => answers.filter((each) => each.test === test && !each.training);
const pairOf = ({ a, b }: Answer): string => [a, b].sort().join(' and ');

export const abxFigures = (answers: readonly Answer[]): AbxFigures[] => {
  const all = counted(answers, 'abx');
  return [...new Set(all.map(pairOf))].sort().map((pair) => {
    const mine = all.filter((each) => pairOf(each) === pair), right = mine.filter(({ x, answer }) => x === answer).length;
    return { pair, right, of: mine.length, p: guessing(right, mine.length) };
  });
};

/** Listeners who rate the hidden reference under 90 in more than 15 % of the trials: BS.1534-3 (4.1.2) leaves them out. */
export const screenedOut = (answers: readonly Answer[]): string[] => {
  const references = counted(answers, 'rating').filter(({ sound }) => sound === 'recorded');
  return [...new Set(references.map(({ listener }) => listener))].filter((listener) => {
    const mine = references.filter((each) => each.listener === listener);
    return mine.filter(({ score }) => (score ?? 0) < 90).length > 0.15 * mine.length;
  });
};

/** Without those who are left out, unless that is everybody. */
export const ratingFigures = (answers: readonly Answer[]): RatingFigures[] => {
  const all = counted(answers, 'rating'), out = new Set(screenedOut(answers)), kept = all.filter(({ listener }) => !out.has(listener)), used = kept.length > 0 ? kept : all;
  return [...new Set(used.map(({ sound }) => sound as Kind))].map((sound) => {
    const scores = used.filter((each) => each.sound === sound).map(({ score }) => score as number);
    return { sound, count: scores.length, median: median(scores), interval: medianInterval(scores) };
  }).sort((one, other) => other.median - one.median);
};

export const figuresCsv = (answers: readonly Answer[]): string => csvRows([['test', 'what', 'count', 'right', 'p', 'median', 'low_95', 'high_95'],
  ...abxFigures(answers).map(({ pair, right, of, p }) => ['abx', pair, of, right, p, '', '', '']),
  ...ratingFigures(answers).map((row) => ['rating', row.sound, row.count, '', '', row.median, ...(row.interval ?? ['', ''])])]);
