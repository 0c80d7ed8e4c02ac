// The Rig page as one file: small enough for a memory stick's attachment, plays from file:// and asks nothing of any network.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudnessThat, openPage, photograph } from './browser.mjs';
import { pages, rigsound } from './places.mjs';
import { playedDigest, renderedDigest } from './same_samples.mjs';
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
  for (const mark of ['RIGSOUND_ENGINE', 'RIGSOUND_RIGSET', 'RIGSOUND_RIG_JSON']) assert.equal(template.split(mark).length, 2, mark);
});

test('it plays from a file, without a request', async () => {
  const { page } = studio, asked = [];
  page.on('request', (request) => { if (!/^(blob|data):/.test(request.url())) asked.push(request.url()); });
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await loudnessThat(page, (found) => found > 1e-3);
  await page.getByRole('slider', { name: 'Feed', exact: true }).fill('200');
  await page.locator('.situation').getByText('Overfeed').waitFor();
  await photograph(page, 'export');
  assert.deepEqual(asked, []);
  assert.deepEqual(await complaints(page), []);
  assert.deepEqual(studio.problems, []);
});

test('10 s of its samples are those of rigsound render', async () => {
  const [, worklet] = /id="worklet">([^<]*)</.exec(readFileSync(join(folder, 'page.html'), 'utf8'));
  const parts = await studio.page.evaluateHandle((text) => {
    const { module, set } = window.heard.nodes.at(-1).madeWith;
    return { worklet: `data:text/javascript;base64,${text}`, module, set };
  }, worklet);
  assert.equal(await playedDigest(parts), renderedDigest(set));
});
