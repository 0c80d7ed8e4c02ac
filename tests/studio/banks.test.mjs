// Compare and Refine: switching keeps the place, a refinement is heard from the engine and saved by its version.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, loudnessThat, openPage, photograph, until } from './browser.mjs';
import * as documents from './documents.mjs';
import { fakeServer } from './fake_server.mjs';
import { pages } from './places.mjs';
import { smallSet } from './small_set.mjs';
import { constant, tone } from './sounds.mjs';

const kName = 'normal_01500ms';
const kCapture = `registerProcessor('capture', class extends AudioWorkletProcessor {
  process([input]) { if (input[0]) this.port.postMessage([...input[0]]); return true; } });`;
let set, server, studio, page, conflict = false, held = null;
const written = () => JSON.parse(server.asked.filter(({ method }) => method === 'PUT').at(-1).body);
before(async () => {
  set = smallSet();
  server = await fakeServer(pages, {
    'GET /state': documents.withRecording, 'GET /sound_set': documents.withBanks, 'GET /rig': documents.rig, 'GET /sound_set.rigset': set.packed,
    'GET /banks/': async ({ path }) => { await held; return documents.bank(path.split('/').pop()); }, 'GET /banks/overfeed_09000ms': { status: 422, json: { error: 'clicks.wav: is cut off' } },
    [`GET /banks/${kName}/sound/recorded`]: constant(0.1, 4), [`GET /banks/${kName}/sound/denoised`]: constant(0.2, 4), [`GET /banks/${kName}/sound/synthesised`]: constant(0.3, 4),
    [`GET /banks/${kName}/clicks/`]: tone(900, 0.05),
    [`PUT /banks/${kName}/refinement`]: ({ body }) => (conflict ? { status: 409, json: { error: 'changed', version: 'r9' } } : { ...body, version: 'r1' }),
    [`DELETE /banks/${kName}/refinement`]: documents.refinement }, { '/capture.js': kCapture });
  studio = await openPage(server.address, { at: 'compare' });
  page = studio.page;
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
});
after(async () => { await closeBrowser(); await server?.stop(); set?.end(); });

test('switching is without a gap and at the same place', async () => {
  await photograph(page, 'compare');
  await page.evaluate(() => {
    const { connect } = AudioNode.prototype;
    AudioNode.prototype.connect = function (to, ...rest) {
      if (to instanceof AudioDestinationNode && this instanceof GainNode && window.capture) connect.call(this, window.capture);
      return connect.call(this, to, ...rest);
    };
  });
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction(() => window.heard.sources.length >= 3);
  await page.evaluate(async () => {
    const { context } = window.heard.sources.at(-1);
    await context.audioWorklet.addModule('capture.js');
    const node = new AudioWorkletNode(context, 'capture', { numberOfOutputs: 0 });
    window.captured = [];
    node.port.onmessage = ({ data }) => window.captured.push(...data);
    window.capture = node;
  });
  await page.getByRole('button', { name: 'Stop' }).click();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.locator('main').focus();
  for (const key of ['r', 'd', 's', 'r', 's', '']) {
    const length = await page.evaluate(() => window.captured.length);
    await page.waitForFunction((from) => window.captured.length > from + 9600, length);
    if (key) await page.keyboard.press(key);
  }
  const { starts, samples } = await page.evaluate(() => {
    const sources = window.heard.sources.slice(-3);
    return { starts: sources.map(({ loopStart, loopEnd, loop }) => [loopStart, loopEnd, loop].join()), samples: window.captured };
  });
  assert.equal(new Set(starts).size, 1);
  const first = samples.findIndex((v) => v > 0.09), heard = samples.slice(first + 4800);
  assert.ok(heard.length > 24000, `${samples.length} samples`);
  // Constants of 0.1, 0.2 and 0.3 with a fade of 4 ms between them: neither silence nor a step.
  assert.ok(heard.every((v) => v > 0.0999 && v < 0.3001), `${Math.min(...heard)}...${Math.max(...heard)}`);
  const step = heard.reduce((most, v, n) => Math.max(most, n ? Math.abs(v - heard[n - 1]) : 0), 0);
  assert.ok(step < 0.2 / (0.004 * 48000) * 1.5, String(step));
  assert.ok(heard.some((v) => Math.abs(v - 0.3) < 1e-3) && heard.some((v) => Math.abs(v - 0.2) < 1e-3));
  await page.getByRole('button', { name: 'Stop' }).click();
  assert.deepEqual(await complaints(page), []);
});

test('a bank that cannot be read says why', async () => {
  await page.getByRole('button', { name: /overfeed_09000ms/ }).click();
  await page.getByText('clicks.wav: is cut off').waitFor();
  await photograph(page, 'compare_error');
});

test('a bank chosen again while it is on its way is opened once', async () => {
  let release;
  held = new Promise((done) => { release = done; });
  const before_ = server.asked.length;
  const openings = () => server.asked.slice(before_).filter(({ path }) => path === `/banks/${kName}`).length;
  await page.evaluate(() => { location.hash = '#/refine'; });
  await until('does not open its first bank', () => openings() > 0);
  await page.getByRole('button', { name: new RegExp(kName) }).click();
  await page.getByRole('button', { name: new RegExp(kName) }).click();
  release();
  held = null;
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  assert.equal(openings(), 1);
});

test('a refinement is heard at once', async () => {
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  const before_ = await loudnessThat(page, (found) => found > 1e-3);
  await page.getByRole('slider', { name: 'Level trim' }).fill('-24');
  await loudnessThat(page, (found) => Math.abs(20 * Math.log10(found / before_) + 24) < 3);
  await photograph(page, 'refine');
});

test('it is undone, saved by its version, and set back', async () => {
  await page.locator('main').focus();
  await page.keyboard.press('Control+z');
  await page.getByRole('slider', { name: 'Decay' }).fill('1.5');
  await page.getByRole('checkbox', { name: 'Click 2' }).uncheck();
  await until('not asked for the clicks that are left', () => server.asked.some(({ query }) => query.includes('clicks=0,2,3,4,5') || query.includes('clicks=0%2C2')));
  await page.keyboard.press('Control+s');
  await page.getByText('Saved.').waitFor();
  const { version, controls, dropped, trim_db } = written();
  assert.deepEqual({ version, decay: controls.decay_factor, dropped, trim_db }, { version: 'absent', decay: 1.5, dropped: [1], trim_db: 0 });
  conflict = true;
  await page.getByRole('slider', { name: 'Attack' }).fill('2');
  await page.getByRole('button', { name: 'Save' }).click();
  await page.getByText('refined elsewhere').waitFor();
  await photograph(page, 'refine_conflict');
  conflict = false;
  await page.getByRole('button', { name: 'Keep mine' }).click();
  await page.getByText('Saved.').waitFor();
  assert.equal(written().version, 'r9');
  await page.getByRole('button', { name: 'Back to analysed' }).click();
  await page.getByText('Back at the analysed values').waitFor();
  assert.equal(await page.getByRole('slider', { name: 'Decay' }).inputValue(), '1');
  assert.deepEqual(await complaints(page), []);
});
