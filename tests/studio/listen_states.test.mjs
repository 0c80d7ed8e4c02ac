// The Listen page when something is missing or fails, and how it switches between the sounds of a trial.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, openPage, photograph } from './browser.mjs';
import * as documents from './documents.mjs';
import { fakeServer } from './fake_server.mjs';
import { pages } from './places.mjs';
import { wav } from './sounds.mjs';

const kRate = 48000, kPlaces = ['a', 'b', 'x'], kCapture = `registerProcessor('capture', class extends AudioWorkletProcessor {
  process([input]) { if (input[0]) this.port.postMessage([...input[0]]); return true; } });`;
const kTrials = 'POST /listen/trials', kEnd = 'DELETE /listen/trials/', kSave = 'POST /listen/results';
// Rises by the same from one sample to the next in all three, each from a level of its own: a sample says whose it is and where.
const kSeconds = 4, kLevels = { a: 0.1, b: 0.3, x: 0.5 }, kRise = 0.1 / (kSeconds * kRate);
const ramp = (place) => wav(Float32Array.from({ length: kSeconds * kRate }, (_, n) => kLevels[place] + kRise * n));

let server, studio, page, trials = 0;
before(async () => {
  server = await fakeServer(pages, {
    'GET /state': documents.state, 'GET /sound_set': documents.withBanks, 'GET /listen/results': { results: [] },
    [kTrials]: () => ({ id: `t${++trials}`, seconds: kSeconds, sounds: kPlaces }), 'GET /listen/trials/': ({ path }) => ramp(path.split('/').pop()),
    [kEnd]: { sounds: { a: 'denoised', b: 'synthesised', x: 'denoised' } }, [kSave]: { name: '2026-01-01T00-00-00Z.csv' } }, { '/capture.js': kCapture });
  studio = await openPage(server.address, { at: 'listen' });
  page = studio.page;
  await page.getByRole('button', { name: 'Begin', exact: true }).waitFor();
});
after(async () => { await closeBrowser(); await server?.stop(); });
const open = async (soundSet) => {
  server.routes['GET /sound_set'] = soundSet;
  await page.evaluate(() => { location.hash = '#/rig'; });
  await page.evaluate(() => { location.hash = '#/listen'; });
};
const begin = async (trialCount) => {
  await page.getByLabel('Trials').fill(String(trialCount));
  await page.getByLabel('Trials').press('Tab');
  await page.getByRole('checkbox', { name: 'Begin with a trial' }).uncheck();
  await page.getByRole('button', { name: 'Begin', exact: true }).click();
};
const answerOne = async (n, of) => {
  await page.getByRole('heading', { name: `Trial ${n} of ${of}` }).waitFor();
  for (const key of [...kPlaces, 'ArrowLeft']) await page.keyboard.press(key);
};

test('switching keeps the place to the sample, without a gap', async () => {
  await begin(1);
  await page.getByRole('heading', { name: 'Trial 1 of 1' }).waitFor();
  await page.keyboard.press('a');
  await page.waitForFunction(() => window.heard.sources.length >= 3);
  // Every gain of the player into one recorder of samples.
  await page.evaluate(async () => {
    const { context } = window.heard.sources.at(-1), { connect } = AudioNode.prototype;
    await context.audioWorklet.addModule('capture.js');
    const recorder = new AudioWorkletNode(context, 'capture', { numberOfOutputs: 0 });
    window.captured = [];
    recorder.port.onmessage = ({ data }) => window.captured.push(...data);
    AudioNode.prototype.connect = function (to, ...rest) {
      if (to instanceof AudioDestinationNode && this instanceof GainNode) connect.call(this, recorder);
      return connect.call(this, to, ...rest);
    };
  });
  await page.keyboard.press('Space');
  await page.getByRole('button', { name: 'Go on' }).waitFor();
  await page.evaluate(() => { window.captured.length = 0; });
  await page.keyboard.press('Space');
  for (const key of ['b', 'x', 'a', 'x', 'b', 'a']) {
    const length = await page.evaluate(() => window.captured.length);
    await page.waitForFunction((from) => window.captured.length > from + 7000, length);
    await page.keyboard.press(key);
  }
  const all = await page.evaluate(() => window.captured), heard = all.slice(all.findIndex((v) => v > 0));
  // A sample is one sound's alone when it lies on its ramp; within a fade of 4 ms it lies between two.
  const places = heard.map((v) => {
    const [place, level] = Object.entries(kLevels).find(([, from]) => v > from - 1e-4 && v < from + 0.1001) ?? [];
    return place ? { place, at: Math.round((v - level) / kRise) } : null;
  });
  const origin = (n) => ((places[n].at - n) % (kSeconds * kRate) + kSeconds * kRate) % (kSeconds * kRate);
  const alone = [...places.keys()].filter((n) => n > 0 && places[n] && places[n - 1]?.place === places[n].place && places[n].at - places[n - 1].at === 1);
  assert.ok(alone.length > 0.95 * (heard.length - 8 * 192 - kRate / 10), `${alone.length} of ${heard.length}`);
  const origins = new Map(alone.map((n) => [origin(n), places[n].place]));
  console.log(`samples ${heard.length}, places of the beginning: ${[...origins.keys()].join(' ')}`);
  assert.ok(Math.max(...origins.keys()) - Math.min(...origins.keys()) <= 1, [...origins.keys()].join(' '));
  assert.deepEqual(new Set(alone.map((n) => places[n].place)), new Set(kPlaces));
  assert.ok(heard.every((v) => v > 0.0999), `silence of ${heard.filter((v) => v <= 0.0999).length} samples`);
  // Sounds that are fetched at once share the one output.
  assert.equal(await page.evaluate(() => new Set(window.heard.sources.map(({ context }) => context)).size), 1);
  await page.keyboard.press('ArrowLeft');
  await page.getByText('Saved with the sound set').waitFor();
});

test('sounds that are waited for and sounds that cannot be made', async () => {
  let release;
  server.routes[kTrials] = () => new Promise((done) => { release = () => done({ status: 404, json: { error: 'its recording has changed since the analysis' } }); });
  await page.getByRole('button', { name: 'Another test' }).click();
  await begin(1);
  await page.getByText('Getting the sounds').waitFor();
  await photograph(page, 'listen_loading');
  assert.deepEqual(await complaints(page), []);
  release();
  await page.getByText('its recording has changed since the analysis').waitFor();
  await photograph(page, 'listen_error');
  assert.deepEqual(await complaints(page), []);
  server.routes[kTrials] = () => ({ id: `t${++trials}`, seconds: kSeconds, sounds: kPlaces });
  await page.keyboard.press('Enter');
  await answerOne(1, 1);
  await page.getByText('Saved with the sound set').waitFor();
});

test('a studio that ends in the middle takes no answer with it', async () => {
  await page.getByRole('button', { name: 'Another test' }).click();
  await begin(3);
  await answerOne(1, 3);
  await page.getByRole('heading', { name: 'Trial 2 of 3' }).waitFor();
  await server.stop();
  await answerOne(2, 3);
  await page.getByRole('heading', { name: 'That did not work' }).waitFor();
  await page.locator('.banner').waitFor();
  await photograph(page, 'listen_offline');
  assert.deepEqual(await complaints(page), []);
  // It comes back, started anew: what was what in the open trial is lost, and asked for once more.
  server.routes[kEnd] = { status: 404, json: { error: 'there is no such trial' } };
  await server.start();
  await page.locator('.banner').waitFor({ state: 'detached' });
  await page.getByRole('button', { name: 'Try again' }).click();
  await page.getByRole('heading', { name: 'Once more' }).waitFor();
  await photograph(page, 'listen_once_more');
  server.routes[kEnd] = { sounds: { a: 'denoised', b: 'synthesised', x: 'denoised' } };
  await page.keyboard.press('Enter');
  await answerOne(2, 3);
  await answerOne(3, 3);
  await page.getByRole('heading', { name: '3 of 3 right' }).waitFor();
});

test('answers that cannot be saved are kept, downloaded and saved again', async () => {
  server.routes[kSave] = { status: 503, json: { error: 'listening: No space left on device' } };
  await page.getByText('Saved with the sound set').waitFor();
  await page.getByRole('button', { name: 'Another test' }).click();
  await begin(1);
  await answerOne(1, 1);
  await page.getByText('No space left on device').waitFor();
  await photograph(page, 'listen_not_saved');
  assert.deepEqual(await complaints(page), []);
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name: 'Download answers' }).click()]);
  assert.equal(file.suggestedFilename(), 'listening.csv');
  // Nothing is left behind without a question.
  const asked = [];
  page.on('dialog', (dialog) => { asked.push(dialog.message()); void dialog.dismiss(); });
  await page.getByRole('button', { name: 'Another test' }).click();
  assert.match(asked[0], /not saved/);
  server.routes[kSave] = { name: '2026-01-01T00-00-01Z.csv' };
  await page.getByRole('button', { name: 'Save again' }).click();
  await page.getByText('listening/2026-01-01T00-00-01Z.csv').waitFor();
});

test('without banks, or without their recordings, it says what to do', async () => {
  for (const [name, soundSet, words] of [['empty_listen', documents.soundSet, 'no banks yet'],
    ['listen_no_recordings', { ...documents.withBanks, banks: documents.withBanks.banks.map((bank) => ({ ...bank, recording: null })) }, 'None of the banks has its recording']]) {
    await open(soundSet);
    await page.getByText(words).waitFor();
    await photograph(page, name);
    assert.deepEqual(await complaints(page), []);
  }
  // A browser says itself when a server does not answer, or refuses.
  assert.deepEqual(studio.problems.filter((line) => !/Failed to load resource|net::ERR/.test(line)), []);
});
