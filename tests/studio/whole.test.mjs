// From a recording to a refined bank through the program's own server: annotate, analyse, compare, refine, save, hear.
import assert from 'node:assert/strict';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudnessThat, openPage, photograph } from './browser.mjs';
import { rigsound, root } from './places.mjs';
import { run } from './small_set.mjs';
import { startStudio } from './studio_program.mjs';
import { analyse, annotate, bankOf, compare, go, refine } from './way.mjs';

const kSituations = ['normal', 'overfeed', 'underfeed', 'closed_rattling', 'open_rattling'];
let folder, studio, opened, page;
const place = (...words) => join(folder, ...words);
const bank = () => bankOf(folder, 'normal');
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'rigsound_whole.'));
  mkdirSync(place('recordings'));
  run(rigsound, 'simulate', '--out', place('simulated'), '--seed', '3');
  for (const name of kSituations) copyFileSync(place('simulated', `${name}.wav`), place('recordings', `${name}.wav`));
  copyFileSync(join(root, 'config/logs/shift.log'), place('recordings/shift.log'));
  const rig = readFileSync(join(root, 'config/rigs/demo.toml'), 'utf8').replace('"../../out/soundset"', `"${place('set')}"`)
    .replaceAll('"../dbc/', `"${join(root, 'config/dbc')}/`).replace(/^tool = "rods"/m, '#');
  writeFileSync(place('rig.toml'), rig);
  studio = await startStudio(place('set'), '--recordings', place('recordings'), '--rig', place('rig.toml'));
  opened = await openPage(studio.address);
  page = opened.page;
  await page.getByRole('button', { name: 'New part' }).waitFor();
});
after(async () => { await closeBrowser(); await studio?.stop(); rmSync(folder, { recursive: true, force: true }); });

test('annotate: a part is drawn by keys, named and saved as Audacity reads it', async () => {
  await annotate(page, 'whole', { shown: 'normal.wav (0:18)', beside: 'normal.wav', from: 1, to: 17, situation: 'normal', rods: 2 });
  const lines = readFileSync(place('recordings/normal.txt'), 'utf8').trim().split('\n');
  assert.match(lines[0], /^1\.000000\t17\.000000\tnormal rods=2$/);
});

test('analyse: every recording becomes a bank', async () => {
  for (const name of kSituations.slice(1)) writeFileSync(place('recordings', `${name}.txt`), `1.000000\t17.000000\t${name}\n`);
  await analyse(page, 'whole', kSituations.map((name) => `${name}.wav`));
  assert.ok(existsSync(place('set/banks', bank(), 'bank.json')));
});

test('compare: the three sounds and their figures', () => compare(page, 'whole', bank()));

test('refine: a saved value changes what resynth plays, and back', () => refine(page, 'whole', folder, bank()));

test('rig: the banks that were made sound', async () => {
  await go(page, 'rig');
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.locator('.situation').getByText('Normal').waitFor();
  await loudnessThat(page, (found) => found > 1e-4);
  await photograph(page, 'whole_rig');
});

test('every page is accessible and its console quiet', async () => {
  for (const id of ['annotate', 'analyse', 'compare', 'refine', 'steel', 'diesel', 'rig', 'listen', 'live']) {
    await go(page, id);
    await page.waitForTimeout(1500);
    await photograph(page, `whole_end_${id}`);
    assert.deepEqual(await complaints(page), [], id);
  }
  // What is not there is asked for once: a bank whose recording is gone.
  assert.deepEqual(opened.problems.filter((line) => !line.includes('404')), []);
});

test('export: the Rig page as one file under 3 MB', () => {
  run(rigsound, 'studio', place('set'), '--rig', place('rig.toml'), '--pages', join(process.env.RIGSOUND_BUILD ?? join(root, 'build/release'), 'tools/studio/web'), '--export', place('page.html'));
  const html = readFileSync(place('page.html'));
  assert.ok(html.length <= 3e6, String(html.length));
  console.log(`exported page: ${html.length} octets`);
});
