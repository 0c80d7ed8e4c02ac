// Answers of a listening test: as rows, as CSV, as figures.
import type { Kind } from './trial_sounds';
import { guessing, median, medianInterval } from './statistics';

export interface Answer {
  test: 'abx' | 'rating'; listener: string; trial: number; bank: string; training: boolean;
  /** ABX: what A, B and X were, and what X was taken for. */
  a?: Kind; b?: Kind; x?: Kind; answer?: Kind;
  /** Rating: one row a sound. */
  sound?: Kind; score?: number;
  seconds: number;
}

const kColumns = ['test', 'listener', 'trial', 'bank', 'training', 'a', 'b', 'x', 'answer', 'right', 'sound', 'score', 'seconds'] as const;
const cell = (value: unknown): string => {
  const text = value === undefined ? '' : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

export const csvOf = (answers: readonly Answer[]): string => [kColumns.join(','), ...answers.map((each) => kColumns.map((column) =>
  cell(column === 'right' ? (each.x ? Number(each.x === each.answer) : undefined) : column === 'training' ? Number(each.training) : each[column])).join(','))].join('\n') + '\n';

export interface AbxFigures { right: number; of: number; p: number }
export const abxFigures = (answers: readonly Answer[]): AbxFigures => {
  const counted = answers.filter(({ test, training }) => test === 'abx' && !training), right = counted.filter(({ x, answer }) => x === answer).length;
  return { right, of: counted.length, p: guessing(right, counted.length) };
};

export interface RatingFigures { sound: Kind; count: number; median: number; interval: [number, number] | null }
export const ratingFigures = (answers: readonly Answer[]): RatingFigures[] => {
  const counted = answers.filter(({ test, training }) => test === 'rating' && !training);
  return [...new Set(counted.map(({ sound }) => sound as Kind))].sort().map((sound) => {
    const scores = counted.filter((each) => each.sound === sound).map(({ score }) => score as number);
    return { sound, count: scores.length, median: median(scores), interval: medianInterval(scores) };
  });
};

/** BS.1534-3, 4.1.2: who rates the hidden reference under 90 in more than 15 % of the trials is left out. */
export const isScreenedOut = (answers: readonly Answer[]): boolean => {
  const references = answers.filter(({ training, sound }) => !training && sound === 'recorded');
  return references.filter(({ score }) => (score ?? 0) < 90).length > 0.15 * references.length;
};
