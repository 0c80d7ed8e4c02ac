// The Diesel page on the program itself: what runs is what the picture says, follows the sliders, and stands beside its recording.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudness, openPage, photograph, powerAt, samples, widths } from './browser.mjs';
import { rigsound } from './places.mjs';
import { run, smallSet } from './small_set.mjs';
import { startStudio } from './studio_program.mjs';

const kLearned_rpm = 1500;
let set, studio, opened, page;
before(async () => {
  set = smallSet();
  const sounds = join(set.folder, 'sounds'), recordings = join(set.folder, 'recordings');
  mkdirSync(recordings);
  run(rigsound, 'background', '--formula', '--name', 'diesel', '--out', sounds);
  run(rigsound, 'background', '--formula', '--resynth', join(recordings, 'mid.wav'), '--resynth-rpm', String(kLearned_rpm), '--seconds', '9');
  run(rigsound, 'background', join(recordings, 'mid.wav'), '--rpm', String(kLearned_rpm), '--name', 'learned', '--out', sounds);
  studio = await startStudio(sounds, '--rig', set.rig, '--recordings', recordings);
  opened = await openPage(studio.address, { at: 'diesel' });
  page = opened.page;
  await page.getByRole('button', { name: 'Start' }).waitFor();
});
after(async () => { await closeBrowser(); await studio?.stop(); set?.end(); });

const slider = (name) => page.getByRole('slider', { name });
const orders = async () => (await page.locator('[aria-label="Loudest orders"] tbody tr').allInnerTexts()).map((row) => row.split('\t').map(Number));
/** Whether the loudest orders of the table stand out of what is played. */
const runsAt = async (rows) => {
  const heard = await samples(page, 0.65);
  return rows.slice(0, 3).every(([order, hz]) => powerAt(heard, hz) > powerAt(heard, hz * (order + 0.25) / order) + 6);
};

test('the orders of a speed stand there, and its sound has them', async () => {
  await page.getByRole('cell').first().waitFor();
  await page.waitForFunction(() => document.querySelector('[aria-label="Loudest orders"] td'));
  await photograph(page, 'diesel');
  assert.deepEqual(await complaints(page), []);
  await page.locator('main').focus();
  await page.keyboard.press(' ');
  await page.waitForTimeout(3000);
  assert.ok(await loudness(page) > 1e-3);
  const rows = await orders();
  assert.equal(rows[0][0] % 3, 0);
  assert.ok(await runsAt(rows), String(rows));
  await photograph(page, 'diesel_running');
});

test('another speed is another sound and another picture', async () => {
  const [before_] = await orders();
  await slider('Speed').fill('1230');
  await page.waitForFunction((hz) => Number(document.querySelector('[aria-label="Loudest orders"] tr td:nth-child(2)').textContent) !== hz, before_[1]);
  await page.waitForFunction(() => [...document.querySelectorAll('.legend li')].some((each) => each.textContent.includes('1230')));
  await page.waitForTimeout(2500);
  const rows = await orders();
  for (const [order, hz] of rows) assert.ok(Math.abs(hz - order * 1230 / 60) < 0.06, `${order} ${hz}`);
  assert.ok(await runsAt(rows), String(rows));
});

test('how soon a slider is heard is a figure, not a verdict', async () => {
  const delays = [];
  for (let turn = 0; turn < 5; ++turn) {
    await slider('Load').fill('0');
    await page.waitForTimeout(800);
    delays.push(await page.evaluate(async () => {
      const node = window.heard.nodes.at(-1), analyser = node.context.createAnalyser(), x = new Float32Array(2048);
      analyser.fftSize = 2048;
      node.connect(analyser);
      const level = () => { analyser.getFloatTimeDomainData(x); return Math.sqrt(x.reduce((sum, v) => sum + v * v, 0) / x.length); };
      let most = 0;
      for (const end = performance.now() + 600; performance.now() < end; most = Math.max(most, level())) await new Promise((done) => setTimeout(done, 5));
      const input = document.querySelectorAll('[aria-label="Speed and load"] input[type=range]')[1], began = performance.now();
      input.value = '1';
      input.dispatchEvent(new Event('input'));
      while (level() <= 1.02 * most && performance.now() - began < 2000) await new Promise((done) => setTimeout(done));
      node.disconnect(analyser);
      return performance.now() - began + 1000 * node.context.baseLatency;
    }));
  }
  assert.ok(delays.every((delay) => delay < 2000), String(delays));
  console.log(`slider to sound, context's own latency and a window of 43 ms included: median ${delays.sort((a, b) => a - b)[2].toFixed(1)} ms of ${delays.map((d) => d.toFixed(1)).join(' ')}`);
  await slider('Load').fill('0');
});

test('beyond what was learned it says so', async () => {
  await page.locator('main').focus();
  for (let n = 0; n < 60; ++n) await page.keyboard.press('ArrowUp');
  await page.getByText('beyond, its colour stays').waitFor();
  await photograph(page, 'diesel_beyond');
});

test('it stops, and dies away', async () => {
  await page.locator('main').focus();
  await page.keyboard.press(' ');
  await page.getByRole('button', { name: 'Start' }).waitFor();
  await page.waitForTimeout(6000);
  assert.ok(await loudness(page, 0.2) < 1e-4);
});

test('a recording at hand is seen and heard beside the model', async () => {
  await page.getByRole('combobox', { name: 'Background' }).selectOption('learned');
  await page.getByText(`recorded at ${kLearned_rpm} r/min`).waitFor({ timeout: 60000 });
  assert.ok(await page.getByRole('radio', { name: 'Recording' }).isDisabled());
  await page.getByRole('button', { name: 'Start' }).click();
  await page.waitForTimeout(2500);
  await page.locator('main').focus();
  await page.keyboard.press('r');
  await page.waitForFunction(() => window.heard.sources.length > 0 && window.heard.sources.at(-1).buffer.duration > 8);
  await photograph(page, 'diesel_recording');
  assert.deepEqual(await complaints(page), []);
  await page.keyboard.press('r');
  assert.ok(await page.getByRole('radio', { name: 'Model' }).isChecked());
  await slider('Speed').fill('1400');
  assert.ok(await page.getByRole('radio', { name: 'Recording' }).isDisabled());
  await page.getByRole('button', { name: /Set 1500/ }).click();
  await page.getByText(`recorded at ${kLearned_rpm} r/min`).waitFor();
  await page.getByRole('button', { name: 'Stop' }).click();
});

test('its keys stand in the list, it fits its window, and its console is quiet', async () => {
  await page.locator('main').focus();
  await page.keyboard.press('?');
  await page.getByRole('dialog').getByText('Faster').waitFor();
  await page.keyboard.press('Escape');
  assert.deepEqual(await widths(page, 'diesel'), []);
  assert.deepEqual(opened.problems, []);
});

test('while it opens it says so; one that cannot be read says why, and is read once it can', async () => {
  const other = await openPage(studio.address, { at: 'live' });
  let go;
  await other.page.route('**/diesel/diesel', async (route) => { await new Promise((done) => { go = done; }); await route.fulfill({ status: 422, json: { error: 'background.json: points: there are none' } }); });
  await other.page.evaluate(() => { location.hash = '#/diesel'; });
  await other.page.getByText('Opening the diesel').waitFor();
  await photograph(other.page, 'diesel_loading');
  go();
  await other.page.getByText('points: there are none').waitFor();
  await photograph(other.page, 'diesel_error');
  assert.deepEqual(await complaints(other.page), []);
  await other.page.unroute('**/diesel/diesel');
  await other.page.getByRole('button', { name: 'Try again' }).click();
  await other.page.getByRole('button', { name: 'Start' }).waitFor();
  await other.close();
});

test('without a server it says so', async () => {
  await studio.stop();
  studio = null;
  await slider('Speed').fill('1300');
  await page.getByRole('alert').getByText('does not answer').waitFor();
  await photograph(page, 'diesel_offline');
});
