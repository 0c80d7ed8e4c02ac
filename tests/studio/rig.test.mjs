// The Rig page: what sounds is what `rigsound render` gives, sliders reach it, a log plays along its time.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudnessThat, openPage, photograph } from './browser.mjs';
import * as documents from './documents.mjs';
import { fakeServer } from './fake_server.mjs';
import { pages } from './places.mjs';
import { playedDigest, renderedDigest } from './same_samples.mjs';
import { smallSet } from './small_set.mjs';

let set, server, studio;
before(async () => {
  set = smallSet();
  server = await fakeServer(pages, {
    'GET /state': documents.state, 'GET /rig': documents.rig, 'GET /sound_set': documents.withBanks, 'GET /sound_set.rigset': set.packed,
    'GET /logs/c00f12ab9931/timeline': documents.timeline });
  studio = await openPage(server.address, { at: 'rig' });
  await studio.page.getByRole('button', { name: 'Play', exact: true }).waitFor();
});
after(async () => { await closeBrowser(); await server?.stop(); set?.end(); });

test('10 s of its samples are those of rigsound render', async () => {
  const parts = await studio.page.evaluateHandle(async (token) => ({
    worklet: 'worklet.js', module: await WebAssembly.compileStreaming(fetch('engine.wasm')),
    set: new Uint8Array(await (await fetch('/api/v1/sound_set.rigset?rig=1', { headers: { 'X-Rigsound-Token': token } })).arrayBuffer()),
  }), new URL(server.address).hash.slice(1));
  assert.equal(await playedDigest(parts), renderedDigest(set));
});

test('sound flows once it is played, and stops', async () => {
  await studio.page.getByRole('button', { name: 'Play', exact: true }).click();
  await studio.page.waitForFunction(() => window.heard.nodes.at(-1).context.state === 'running');
  await loudnessThat(studio.page, (found) => found > 1e-3);
  await studio.page.getByText('Normal', { exact: true }).waitFor();
  assert.match(await studio.page.locator('.meter output').first().textContent(), /^−?\d+\.\d dB$/);
});

test('a slider is heard; how soon is a figure, not a verdict', async () => {
  const { page } = studio;
  const lever = page.getByRole('slider', { name: 'Feed', exact: true });
  const delays = [];
  for (let turn = 0; turn < 5; ++turn) {
    await lever.fill('0');
    await page.getByRole('slider', { name: 'Diesel' }).fill('0');
    await page.waitForTimeout(1500);
    delays.push(await page.evaluate(async () => {
      const node = window.heard.nodes.at(-1), analyser = node.context.createAnalyser(), x = new Float32Array(256);
      analyser.fftSize = 256;
      node.connect(analyser);
      const loudest = () => { analyser.getFloatTimeDomainData(x); return x.reduce((most, v) => Math.max(most, Math.abs(v)), 0); };
      const before = loudest(), slider = document.querySelector('.lever input');
      slider.value = '90';
      const began = performance.now();
      slider.dispatchEvent(new Event('input'));
      while (loudest() <= Math.max(1e-4, 2 * before) && performance.now() - began < 60000) await new Promise((done) => setTimeout(done));
      const took = performance.now() - began;
      node.disconnect(analyser);
      return took + 1000 * node.context.baseLatency;
    }));
  }
  const median = delays.sort((a, b) => a - b)[2];
  assert.ok(delays.every((delay) => delay < 60000));
  console.log(`slider to sound, context's own latency included: median ${median.toFixed(1)} ms of ${delays.map((d) => d.toFixed(1)).join(' ')}`);
});

test('the rocks of the set go by their names', async () => {
  const rock = studio.page.getByRole('combobox', { name: 'Rock' });
  assert.deepEqual(await rock.locator('option').allTextContents(), documents.rig.rocks);
  await rock.selectOption('soft');
});

test('a log plays along its time and moves the lever', async () => {
  const { page } = studio;
  await page.getByLabel('Bus log to play').selectOption({ label: 'shift.log' });
  await page.getByRole('button', { name: 'Play log' }).click();
  const strip = page.locator('.strip canvas'), box = await strip.boundingBox();
  await strip.click({ position: { x: 48 + (box.width - 62) * 22 / 40, y: 10 } });
  await page.getByText('Overfeed', { exact: true }).first().waitFor();
  await page.waitForFunction(() => document.querySelector('.lever input').value === '160');
  await page.locator('.situation.is-overfeed').waitFor();
  await photograph(page, 'rig_log');
  await page.getByRole('button', { name: 'Pause log' }).click();
});

test('keys do what the list of keys says', async () => {
  const { page } = studio;
  await page.locator('main').focus();
  await page.keyboard.press('?');
  await page.getByRole('dialog').getByText('More feed').waitFor();
  await photograph(page, 'keys');
  await page.keyboard.press('Escape');
  const lever = page.getByRole('slider', { name: 'Feed', exact: true }), start = Number(await lever.inputValue());
  await page.keyboard.press('ArrowDown');
  assert.equal(Number(await lever.inputValue()), start - 5);
  await page.locator('main').focus();
  await page.keyboard.press(' ');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await page.locator('.situation').getByText('Silent').waitFor();
});

test('it is accessible, fits its window, and its console is quiet', async () => {
  const { page } = studio;
  await photograph(page, 'rig');
  assert.deepEqual(await complaints(page), []);
  for (const [width, height] of [[1280, 800], [640, 400], [3840, 2160]]) {
    await page.setViewportSize({ width, height });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth), `${width}x${height}`);
    if (width !== 1280) await photograph(page, `rig_${width}`);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  assert.deepEqual(studio.problems, []);
});

test('without a server it says so, and goes on when there is one again', async () => {
  const { page } = studio;
  await server.stop();
  await page.evaluate(() => { location.hash = '#/other'; location.hash = '#/rig'; });
  await page.getByLabel('Bus log to play').selectOption('');
  await page.getByLabel('Bus log to play').selectOption({ label: 'shift.log' });
  await page.getByRole('alert').getByText('does not answer').waitFor();
  await photograph(page, 'offline');
  await server.start();
  await page.locator('.banner').waitFor({ state: 'detached' });
});
