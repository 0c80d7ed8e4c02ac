// Answers of a listening test, as rows and as CSV.
import type { Kind } from './blind_trial';

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
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};
export const csvRows = (rows: readonly (readonly unknown[])[]): string => rows.map((row) => `${row.map(cell).join(',')}\n`).join('');

export const csvOf = (answers: readonly Answer[]): string => csvRows([kColumns, ...answers.map((each) => kColumns.map((column) => {
  if (column === 'right') return each.x ? Number(each.x === each.answer) : undefined;
  return column === 'training' ? Number(each.training) : each[column];
}))]);

/** Rows of cells; a quoted cell may hold commas, quotes and ends of lines. */
const cellsOf = (csv: string): string[][] => {
  const rows: string[][] = [];
  let row: string[] = [];
  for (const [, quoted, plain, end] of csv.matchAll(/(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r?\n|$)/g)) {
    if (end === '' && quoted === undefined && plain === '' && row.length === 0) break;
    row.push(quoted?.replaceAll('""', '"') ?? plain ?? '');
    if (end === ',') continue;
    rows.push(row);
    row = [];
  }
  return rows;
};

/** What csvOf wrote. */
export const answersOf = (csv: string): Answer[] => {
  const [head, ...rows] = cellsOf(csv);
  if (!head || kColumns.some((column) => !head.includes(column))) throw new Error('is no result of a listening test');
  return rows.map((row) => {
    const of = (column: typeof kColumns[number]): string => row[head.indexOf(column)] ?? '';
    const common = { listener: of('listener'), trial: Number(of('trial')), bank: of('bank'), training: of('training') === '1', seconds: Number(of('seconds')) };
    return of('test') === 'abx'
      ? { test: 'abx', ...common, a: of('a') as Kind, b: of('b') as Kind, x: of('x') as Kind, answer: of('answer') as Kind }
      : { test: 'rating', ...common, sound: of('sound') as Kind, score: Number(of('score')) };
  });
};
