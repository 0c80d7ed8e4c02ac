// The Rig page: what sounds is what `rigsound render` gives, sliders reach it, a log plays along its time.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudness, openPage, photograph } from './browser.mjs';
import * as documents from './documents.mjs';
import { fakeServer } from './fake_server.mjs';
import { pages, rigsound } from './places.mjs';
import { run, smallSet } from './small_set.mjs';

const kStates = [[0, 'engine_rpm', 1500], [0.5, 'feed_pressure_bar', 40], [1.5, 'feed_pressure_bar', 90.25], [2, 'rod_count', 3],
  [3.0004, 'feed_pressure_bar', 170], [4, 'percussion_pressure_bar', 120], [5, 'feed_pressure_bar', 0], [5.5, 'rattling', 2],
  [7, 'rattling', 0], [7, 'engine_load', 0.4], [8, 'master_gain_db', -6], [9, 'feed_pressure_bar', 100]];
const kSeconds = 10, kRate = 48000, kBlock = 64;

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
  const blocks = Math.round(kSeconds * kRate / kBlock), last = (blocks - 1) * kBlock / kRate;
  writeFileSync(join(set.folder, 'states.csv'), 'time_s,signal,value\n' +
    [...kStates, [last.toFixed(6), 'feed_pressure_bar', 100]].map((row) => row.join(',')).join('\n') + '\n');
  const rendered = run(rigsound, 'render', set.rig, '--states', join(set.folder, 'states.csv'), '--out', join(set.folder, 'out.wav'));
  const played = await studio.page.evaluate(async ({ states, seconds, rate, token }) => {
    const bytes = await (await fetch('/api/v1/sound_set.rigset?rig=1', { headers: { 'X-Rigsound-Token': token } })).arrayBuffer();
    const context = new OfflineAudioContext(2, seconds * rate, rate);
    await context.audioWorklet.addModule('worklet.js');
    const module = await WebAssembly.compileStreaming(fetch('engine.wasm'));
    const changes = states.map(([time, name, value]) => ({ frame: time * rate, call: 'set', name, boom: 0, value }));
    new AudioWorkletNode(context, 'rigsound', { numberOfInputs: 0, outputChannelCount: [2],
      processorOptions: { module, set: new Uint8Array(bytes), changes } }).connect(context.destination);
    const buffer = await context.startRendering(), samples = new Float32Array(2 * buffer.length);
    for (let channel = 0; channel < 2; ++channel) buffer.getChannelData(channel).forEach((v, n) => { samples[2 * n + channel] = v; });
    let text = '';
    const octets = new Uint8Array(samples.buffer);
    for (let n = 0; n < octets.length; n += 32768) text += String.fromCharCode(...octets.subarray(n, n + 32768));
    return btoa(text);
  }, { states: kStates, seconds: kSeconds, rate: kRate, token: new URL(server.address).hash.slice(1) });
  const digest = createHash('sha256').update(Buffer.from(played, 'base64')).digest('hex');
  assert.equal(rendered.split('\n')[0], `sha256 ${digest}`);
});

test('sound flows once it is played, and stops', async () => {
  await studio.page.getByRole('button', { name: 'Play', exact: true }).click();
  await studio.page.waitForFunction(() => window.heard.nodes.at(-1).context.state === 'running');
  assert.ok(await loudness(studio.page) > 1e-3);
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
      while (loudest() <= Math.max(1e-4, 2 * before) && performance.now() - began < 2000) await new Promise((done) => setTimeout(done));
      const took = performance.now() - began;
      node.disconnect(analyser);
      return took + 1000 * node.context.baseLatency;
    }));
  }
  const median = delays.sort((a, b) => a - b)[2];
  assert.ok(delays.every((delay) => delay < 2000));
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
