// The Rig page as one file: small enough for a memory stick's attachment, plays from file:// and asks nothing of any network.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudness, openPage, photograph } from './browser.mjs';
import { pages, rigsound } from './places.mjs';
import { run, smallSet } from './small_set.mjs';

const kMostBytes = 3e6;
let folder, set, studio;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'rigsound_export.'));
  set = smallSet();
  run(rigsound, 'studio', join(set.folder, 'sounds'), '--rig', set.rig, '--pages', pages, '--export', join(folder, 'page.html'));
  studio = await openPage(pathToFileURL(join(folder, 'page.html')).href);
});
after(async () => { await closeBrowser(); set?.end(); rmSync(folder, { recursive: true, force: true }); });

test('it is small, and what it is made from holds each mark once', () => {
  console.log(`${statSync(join(folder, 'page.html')).size} octets`);
  assert.ok(statSync(join(folder, 'page.html')).size <= kMostBytes);
  const template = readFileSync(join(pages, 'export.html'), 'utf8');
  for (const mark of ['RIGSOUND_ENGINE_BASE64', 'RIGSOUND_RIGSET_BASE64', 'RIGSOUND_RIG_JSON']) assert.equal(template.split(mark).length, 2, mark);
});

test('it plays from a file, without a request', async () => {
  const { page } = studio, asked = [];
  page.on('request', (request) => { if (!/^(blob|data):/.test(request.url())) asked.push(request.url()); });
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForTimeout(500);
  assert.ok(await loudness(page) > 1e-3);
  await page.getByRole('slider', { name: 'Feed', exact: true }).fill('200');
  await page.locator('.situation').getByText('Overfeed').waitFor();
  await photograph(page, 'export');
  assert.deepEqual(asked, []);
  assert.deepEqual(await complaints(page), []);
  assert.deepEqual(studio.problems, []);
});
