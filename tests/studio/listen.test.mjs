// The Listen page: statistics against scipy's, both tests from beginning to end, what is saved.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { mkdtempSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, openPage, photograph } from './browser.mjs';
import * as documents from './documents.mjs';
import { fakeServer } from './fake_server.mjs';
import { build, packages, pages, web } from './places.mjs';
import { tone } from './sounds.mjs';

// scipy 1.10.1: stats.binomtest(k, n, 0.5, 'greater').pvalue
const kBinomial = [[16, 16, 1.52587890625e-05], [12, 16, 0.0384063720703125], [11, 16, 0.1050567626953125], [8, 16, 0.5981903076171875], [0, 10, 1], [59, 100, 0.044313040057033834]];
// numpy.median, and the k-th values from below and from above with scipy's k = stats.binom.ppf(0.025, n, 0.5); none for k = 0
const kMedians = [[[62, 71, 80, 55, 90, 64], 67.5, [55, 90]], [[62, 71, 80, 55, 90, 64, 77, 83, 41, 68], 69.5, [55, 83]],
  [[10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 15, 25, 35, 45, 55], 45, [25, 70]], [[1, 2, 3, 4, 5], 3, null]];
let server, studio, page;
before(async () => {
  server = await fakeServer(pages, {
    'GET /state': documents.state, 'GET /sound_set': documents.withBanks, 'POST /listen/sounds': { gain_db: { recorded: 0, denoised: 1.2, synthesised: 0.4, anchor: 0 }, rms_db: -26 },
    'POST /listen/results': { name: '2026-01-01T00-00-00Z.csv' }, 'GET /banks/': tone(440, 6) });
  studio = await openPage(server.address);
  page = studio.page;
  await page.getByRole('link', { name: 'Listen' }).click();
  await page.getByRole('button', { name: 'Begin' }).waitFor();
});
after(async () => { await closeBrowser(); await server?.stop(); });
const sent = () => JSON.parse(server.asked.filter(({ path, method }) => method === 'POST' && path === '/listen/results').at(-1).body).csv.trim().split('\n').map((row) => row.split(','));

test('figures are those of scipy', async () => {
  const folder = mkdtempSync(join(build, 'statistics.'));
  try {
    await createRequire(join(packages, 'package.json'))('esbuild').build({ entryPoints: [join(web, 'src/listen/statistics.ts')], outfile: join(folder, 'statistics.mjs'), format: 'esm' });
    const { guessing, median, medianInterval } = await import(join(folder, 'statistics.mjs'));
    for (const [k, n, p] of kBinomial) assert.ok(Math.abs(guessing(k, n) - p) < 1e-12, `${k} of ${n}: ${guessing(k, n)}`);
    for (const [values, middle, interval] of kMedians) {
      assert.equal(median(values), middle);
      assert.deepEqual(medianInterval(values), interval);
    }
  } finally { rmSync(folder, { recursive: true }); }
});

test('ABX: practice, trials, a break, the result; nothing tells X', async () => {
  await photograph(page, 'listen');
  await page.getByLabel('Trials').fill('14');
  await page.getByLabel('Trials').press('Tab');
  await page.getByLabel('Listener').fill('N. N.');
  await page.getByRole('button', { name: 'Begin' }).click();
  for (let n = 0; n <= 14; ++n) {
    await page.getByRole('heading', { name: n === 0 ? 'Practice' : `Trial ${n} of 14` }).waitFor();
    assert.ok(await page.getByRole('button', { name: 'X is A' }).isDisabled());
    for (const key of ['a', 'b', 'x']) await page.keyboard.press(key);
    if (n === 1) await photograph(page, 'listen_abx');
    await page.keyboard.press('ArrowLeft');
    if (n === 0) await page.getByRole('button', { name: 'Begin the test' }).click();
    if (n === 12) {
      await page.getByRole('heading', { name: 'A break' }).waitFor();
      await photograph(page, 'listen_break');
      await page.keyboard.press('Enter');
    }
  }
  await page.getByText('Saved with the sound set').waitFor();
  await photograph(page, 'listen_abx_result');
  const [head, ...rows] = sent();
  assert.deepEqual(head.slice(0, 10), ['test', 'listener', 'trial', 'bank', 'training', 'a', 'b', 'x', 'answer', 'right']);
  assert.equal(rows.length, 15);
  const right = rows.filter((row) => row[4] === '0' && row[9] === '1').length;
  await page.getByRole('heading', { name: `${right} of 14 right` }).waitFor();
  // Chance of an honest shuffle to fail this: 2 in 2^14 each.
  for (const column of [5, 7]) assert.equal(new Set(rows.map((row) => row[column])).size, 2);
  assert.ok(rows.every((row) => Number(row[9]) === Number(row[7] === row[8])));
  assert.deepEqual(await complaints(page), []);
});

test('rating: every sound heard and scored, hidden reference and anchor among them', async () => {
  await page.getByRole('button', { name: 'Another test' }).click();
  await page.getByText('Rating: how like the recording?').click();
  await page.getByRole('checkbox', { name: 'Begin with a trial' }).uncheck();
  await page.getByRole('button', { name: 'Begin' }).click();
  for (let n = 1; n <= 6; ++n) {
    await page.getByRole('heading', { name: `Trial ${n} of 6` }).waitFor();
    await page.keyboard.press('r');
    for (let each = 0; each < 4; ++each) {
      await page.keyboard.press('abcd'[each]);
      await page.getByRole('slider', { name: `Score of sound ${each + 1}` }).fill(String(50 + 10 * each));
    }
    if (n === 1) await photograph(page, 'listen_rating');
    await page.getByRole('button', { name: 'Next' }).click();
  }
  await page.getByRole('heading', { name: 'Ratings' }).waitFor();
  await page.getByText('Saved with the sound set').waitFor();
  await photograph(page, 'listen_rating_result');
  const [, ...rows] = sent();
  assert.equal(rows.length, 24);
  assert.deepEqual([...new Set(rows.map((row) => row[10]))].sort(), ['anchor', 'denoised', 'recorded', 'synthesised']);
  assert.deepEqual(await complaints(page), []);
  assert.deepEqual(studio.problems, []);
});
