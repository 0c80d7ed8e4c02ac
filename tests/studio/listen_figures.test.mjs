// Figures and files of listening tests: statistics against scipy's, answers through CSV and back.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { mkdtempSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { build, packages, web } from './places.mjs';

// scipy 1.10.1: stats.binomtest(k, n, 0.5, 'greater').pvalue
const kBinomial = [[16, 16, 1.52587890625e-05], [12, 16, 0.0384063720703125], [11, 16, 0.1050567626953125], [8, 16, 0.5981903076171875], [0, 10, 1],
  [1, 10, 0.9990234375], [10, 10, 0.0009765625], [59, 100, 0.044313040057033834], [75, 100, 2.818141017102701e-07], [100, 100, 7.888609052210118e-31], [1, 1, 0.5],
  [13, 20, 0.13158798217773438]];
// The same: the least k whose p-value is under 0.05.
const kLeast = [[1, null], [4, null], [5, 5], [10, 9], [16, 12], [20, 15], [25, 18], [50, 32], [100, 59]];
// numpy.median, and the k-th values from below and from above with scipy's k = stats.binom.ppf(0.025, n, 0.5); none for k = 0
const kMedians = [[[62, 71, 80, 55, 90, 64], 67.5, [55, 90]], [[62, 71, 80, 55, 90, 64, 77, 83, 41, 68], 69.5, [55, 83]],
  [[10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 15, 25, 35, 45, 55], 45, [25, 70]], [[1, 2, 3, 4, 5], 3, null], [[100], 100, null], [[50, 50, 50, 50, 50, 50, 60], 50, [50, 60]],
  [[47, 51, 76, 95, 3, 14, 83, 95, 25, 31, 87, 42, 27, 83, 25, 41, 65, 55, 8, 2, 87, 76, 84, 54], 52.5, [27, 83]],
  [[82, 33, 45, 79, 12, 30, 12, 45, 98, 13, 38, 40, 91, 20, 50, 26, 2, 75, 6, 28, 50, 49, 11, 99, 75, 97, 9, 73, 29, 54, 93, 27, 73, 16, 32, 97, 42, 52, 29, 11], 41, [29, 52]]];

let folder, statistics, answers, figures;
before(async () => {
  folder = mkdtempSync(join(build, 'listening.'));
  const { build: bundle } = createRequire(join(packages, 'package.json'))('esbuild');
  const module = async (name) => {
    await bundle({ entryPoints: [join(web, `src/listen/${name}.ts`)], outfile: join(folder, `${name}.mjs`), format: 'esm', bundle: true });
    return import(join(folder, `${name}.mjs`));
  };
  [statistics, answers, figures] = [await module('statistics'), await module('answers'), await module('figures')];
});
after(() => rmSync(folder, { recursive: true, force: true }));

test('figures are those of scipy', () => {
  for (const [k, n, p] of kBinomial) assert.ok(Math.abs(statistics.guessing(k, n) / p - 1) < 1e-9, `${k} of ${n}: ${statistics.guessing(k, n)}`);
  for (const [n, k] of kLeast) assert.equal(statistics.leastShown(n), k, String(n));
  for (const [values, middle, interval] of kMedians) {
    assert.equal(statistics.median(values), middle);
    assert.deepEqual(statistics.medianInterval(values), interval);
  }
});

const abx = (x, answer, more = {}) => ({ test: 'abx', listener: 'N. N.', trial: 1, bank: 'normal', training: false, a: 'denoised', b: 'synthesised', x, answer, seconds: 3.5, ...more });
const rating = (sound, score, more = {}) => ({ test: 'rating', listener: 'N. N.', trial: 1, bank: 'normal', training: false, sound, score, seconds: 3.5, ...more });

test('answers come back from their CSV, whatever a listener is called', () => {
  const given = [abx('denoised', 'synthesised', { training: true, trial: 0 }), abx('denoised', 'denoised', { listener: 'Smith, "Ann"\nJ.' }), rating('anchor', 0, { listener: '' }), rating('recorded', 100)];
  const csv = answers.csvOf(given);
  assert.equal(csv.split('\n')[0], 'test,listener,trial,bank,training,a,b,x,answer,right,sound,score,seconds');
  assert.equal(csv.split('\n')[1], 'abx,N. N.,0,normal,1,denoised,synthesised,denoised,synthesised,0,,,3.5');
  assert.deepEqual(answers.answersOf(csv), given);
  assert.deepEqual(answers.answersOf(csv.replaceAll('\n', '\r\n').replace('\r\nJ.', '\nJ.')), given);
  assert.throws(() => answers.answersOf('trial,answer\n1,a\n'), /no result/);
  assert.throws(() => answers.answersOf(''), /no result/);
});

test('ABX: practice does not count, pairs are counted apart', () => {
  const given = [abx('denoised', 'denoised', { training: true }), ...Array.from({ length: 16 }, (_, n) => abx('denoised', n < 12 ? 'denoised' : 'synthesised')),
    abx('recorded', 'recorded', { a: 'synthesised', b: 'recorded' })];
  assert.deepEqual(figures.abxFigures(given).map(({ pair, right, of }) => [pair, right, of]), [['denoised and synthesised', 12, 16], ['recorded and synthesised', 1, 1]]);
  assert.ok(Math.abs(figures.abxFigures(given)[0].p - 0.0384063720703125) < 1e-9);
});

test('ratings: medians from the best down, without who does not hear the reference', () => {
  const good = (score) => ['recorded', 'synthesised'].map((sound, n) => rating(sound, n ? score : 95)), deaf = ['recorded', 'synthesised'].map((sound) => rating(sound, 10, { listener: 'Deaf' }));
  const given = [...[62, 71, 80, 55, 90, 64].flatMap(good), ...deaf];
  assert.deepEqual(figures.screenedOut(given), ['Deaf']);
  assert.deepEqual(figures.ratingFigures(given), [{ sound: 'recorded', count: 6, median: 95, interval: [95, 95] }, { sound: 'synthesised', count: 6, median: 67.5, interval: [55, 90] }]);
  assert.equal(figures.ratingFigures(deaf).length, 2);
  assert.equal(figures.figuresCsv(given), 'test,what,count,right,p,median,low_95,high_95\nrating,recorded,6,,,95,95,95\nrating,synthesised,6,,,67.5,55,90\n');
});
