// From a recording to a refined bank through the program's own server: annotate, analyse, compare, refine, save, hear.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudnessThat, openPage, photograph } from './browser.mjs';
import { rigsound, root } from './places.mjs';
import { run } from './small_set.mjs';
import { startStudio } from './studio_program.mjs';

const kWork_ms = 240000;
let folder, studio, opened, page;
const place = (...words) => join(folder, ...words);
const resynthesised = (bank) => {
  run(rigsound, 'resynth', place('set/banks', bank), place('bank.wav'), '--seconds', '2');
  return createHash('sha256').update(readFileSync(place('bank.wav'))).digest('hex');
};
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'rigsound_whole.'));
  mkdirSync(place('recordings'));
  run(rigsound, 'simulate', '--out', place('simulated'), '--seed', '3');
  for (const name of ['normal', 'overfeed', 'underfeed', 'closed_rattling', 'open_rattling']) copyFileSync(place('simulated', `${name}.wav`), place('recordings', `${name}.wav`));
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
const go = (id) => page.evaluate((to) => { location.hash = `#/${to}`; }, id);
const bank = () => readFileSync(place('set/soundset.toml'), 'utf8').match(/name = "(normal[^"]*)"/)[1];

test('annotate: a part is drawn by keys, named and saved as Audacity reads it', async () => {
  await page.getByRole('combobox', { name: 'Recording' }).selectOption({ label: 'normal.wav (0:18)' });
  await page.getByRole('button', { name: 'New part' }).click();
  await page.getByLabel('To, s').fill('17');
  await page.getByLabel('To, s').press('Tab');
  await page.getByLabel('From, s').fill('1');
  await page.getByLabel('From, s').press('Tab');
  await page.getByLabel('Situation').selectOption('normal');
  await page.getByLabel('Rods').fill('2');
  await page.getByLabel('Rods').press('Tab');
  await page.waitForTimeout(1500);
  await photograph(page, 'whole_annotate');
  await page.getByRole('button', { name: 'Save' }).click();
  await page.getByText('Saved beside normal.wav').waitFor();
  const lines = readFileSync(place('recordings/normal.txt'), 'utf8').trim().split('\n');
  assert.match(lines[0], /^1\.000000\t17\.000000\tnormal rods=2$/);
});

test('analyse: every recording becomes a bank', async () => {
  for (const name of ['overfeed', 'underfeed', 'closed_rattling', 'open_rattling']) writeFileSync(place('recordings', `${name}.txt`), `1.000000\t17.000000\t${name}\n`);
  await go('analyse');
  for (const name of ['normal', 'overfeed', 'underfeed', 'closed_rattling', 'open_rattling']) {
    await page.getByRole('combobox', { name: 'Recording' }).selectOption({ label: `${name}.wav` });
    await page.getByLabel(/0:\d\d\.\d to/).first().waitFor();
    await page.getByRole('button', { name: 'Analyse', exact: true }).click();
  }
  await page.waitForFunction(() => [...document.querySelectorAll('.progress [role=status]')].filter((each) => each.textContent === 'done').length === 5, null, { timeout: kWork_ms });
  await photograph(page, 'whole_analyse');
  assert.ok(existsSync(place('set/banks', bank(), 'bank.json')));
});

test('compare: the three sounds and their figures', async () => {
  await go('compare');
  await page.getByRole('button', { name: new RegExp(bank()) }).click();
  await page.getByText('Third-octave levels').waitFor({ timeout: kWork_ms });
  await page.getByText('synthesised', { exact: true }).first().waitFor();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction(() => window.heard.sources.length >= 3 && window.heard.sources.at(-1).context.state === 'running');
  assert.equal(new Set(await page.evaluate(() => window.heard.sources.slice(-3).map(({ buffer }) => buffer.length))).size, 1);
  await photograph(page, 'whole_compare');
});

test('refine: a saved value changes what resynth plays, and back', async () => {
  const name = bank(), analysed = resynthesised(name);
  await go('refine');
  await page.getByRole('button', { name: new RegExp(name) }).click();
  await page.getByRole('slider', { name: 'Decay' }).fill('2', { timeout: kWork_ms });
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await loudnessThat(page, (found) => found > 1e-4);
  await page.getByRole('button', { name: 'Save' }).click();
  await page.getByText('Saved.').waitFor();
  await photograph(page, 'whole_refine');
  assert.notEqual(resynthesised(name), analysed);
  await page.getByRole('button', { name: 'Back to analysed' }).click();
  await page.getByText('Back at the analysed values').waitFor();
  assert.equal(resynthesised(name), analysed);
});

test('rig: the banks that were made sound', async () => {
  await go('rig');
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.locator('.situation').getByText('Normal').waitFor();
  await loudnessThat(page, (found) => found > 1e-4);
  await photograph(page, 'whole_rig');
});

test('every page is accessible and its console quiet', async () => {
  for (const id of ['annotate', 'analyse', 'compare', 'refine', 'steel', 'diesel', 'rig', 'listen', 'live']) {
    await go(id);
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
