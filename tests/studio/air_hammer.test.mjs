// The same way with a real recording: an air hammer, 2.5 s of it (RIGSOUND_TEST_DATA).
import assert from 'node:assert/strict';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, openPage } from './browser.mjs';
import { startStudio } from './studio_program.mjs';
import { analyse, annotate, bankOf, compare, refine } from './way.mjs';

let folder, studio, opened, page;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'rigsound_air_hammer.'));
  mkdirSync(join(folder, 'recordings'));
  copyFileSync(join(process.env.RIGSOUND_TEST_DATA, 'recordings/airhammer_24hz.wav'), join(folder, 'recordings/hammer.wav'));
  studio = await startStudio(join(folder, 'set'), '--recordings', join(folder, 'recordings'));
  opened = await openPage(studio.address);
  page = opened.page;
  await page.getByRole('button', { name: 'New part' }).waitFor();
});
after(async () => { await closeBrowser(); await studio?.stop(); rmSync(folder, { recursive: true, force: true }); });
const bank = () => bankOf(folder, 'normal');

test('annotate', () => annotate(page, 'air_hammer', { shown: 'hammer.wav (0:03)', beside: 'hammer.wav', from: 0.1, to: 2.4, situation: 'normal', rods: 1 }));
test('analyse: it strikes 22 to 24 times a second', async () => {
  await analyse(page, 'air_hammer', ['hammer.wav']);
  const { T0, sample_rate } = JSON.parse(readFileSync(join(folder, 'set/banks', bank(), 'bank.json'), 'utf8')), rate = sample_rate / T0;
  assert.ok(rate > 22 && rate < 24.5, String(rate));
});
test('compare', () => compare(page, 'air_hammer', bank()));
test('refine', () => refine(page, 'air_hammer', folder, bank()));
test('its console is quiet', () => assert.deepEqual(opened.problems, []));
