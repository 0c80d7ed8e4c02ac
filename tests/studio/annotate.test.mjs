// The Annotate page: parts by pointer and by keys, undo, suggestions, saving, and a track that changed meanwhile.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, openPage, photograph } from './browser.mjs';
import * as documents from './documents.mjs';
import { fakeServer } from './fake_server.mjs';
import { pages } from './places.mjs';
import { peaks, picture, tone } from './sounds.mjs';

const kId = documents.recording.id, kLabels = `GET /recordings/${kId}/labels`, kWrite = `PUT /recordings/${kId}/labels`;
const kSuggested = [{ from_s: 0, to_s: 4, kinds: [], rhythmic: 0.01, rate_hz: null, level_db: -50, confidence: 0.9 },
  { from_s: 4, to_s: 9, kinds: ['level', 'rate'], rhythmic: 0.97, rate_hz: 41.9, level_db: -20.1, confidence: 0.99 },
  { from_s: 12, to_s: 15, kinds: ['level'], rhythmic: 0.8, rate_hz: 30, level_db: -22, confidence: 0.9 }];
const job = (state, more = {}) => ({ id: 'j1', kind: 'suggest', state, progress: 0.4, left_s: 3, done: [], result: null, error: null, ...more });

let server, studio, page, version = 'v1', conflict = false, release;
const written = () => JSON.parse(server.asked.filter(({ method }) => method === 'PUT').at(-1).body);
const tiles = picture((x, y) => (x * 7 + y * 3) % 200 + 20);
before(async () => {
  server = await fakeServer(pages, {
    'GET /state': documents.withRecording, 'GET /sound_set': documents.soundSet,
    [kLabels]: () => ({ version, parts: [documents.part(12, 14, { situation: 'overfeed', rods: 2, rock: 'hard' })], problems: [] }),
    [kWrite]: ({ body }) => (conflict ? { status: 409, json: { error: 'changed', version: 'v9' } } : { version: version = `${version}+`, parts: body.parts, problems: [] }),
    [`GET /recordings/${kId}/peaks`]: ({ path }) => peaks(...path.split('/').slice(-2).map(Number)),
    [`GET /recordings/${kId}/spectrogram`]: tiles, [`GET /recordings/${kId}/audio`]: tone(440, 5),
    'POST /jobs': { id: 'j1' }, 'GET /jobs/j1': job('done', { progress: 1, result: { parts: kSuggested } }),
    'GET /jobs/j1/events': ({ response }) => { response.write(`${JSON.stringify(job('running'))}\n`); release = () => response.end(); } });
  studio = await openPage(server.address);
  page = studio.page;
  await page.getByText('Overfeed').last().waitFor();
});
after(async () => { await closeBrowser(); await server?.stop(); });

const rows = () => page.locator('.parts tbody tr').count();
const at = async (seconds) => {
  const box = await page.locator('.sonagram canvas').boundingBox();
  return { x: box.x + 56 + (box.width - 68) * seconds / 20, y: box.y + 120 };
};
const drag = async (from, to) => {
  const a = await at(from), b = await at(to);
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move((a.x + b.x) / 2, a.y);
  await page.mouse.move(b.x, b.y);
  await page.mouse.up();
};

test('a drag over nothing makes a part, an edge moves it, undo takes both back one by one', async () => {
  await drag(2, 6);
  assert.equal(await rows(), 2);
  assert.ok(Math.abs(Number(await page.getByLabel('To, s').inputValue()) - 6) < 0.05);
  await drag(6, 7);
  assert.ok(Math.abs(Number(await page.getByLabel('To, s').inputValue()) - 7) < 0.05);
  await page.locator('main').focus();
  await page.keyboard.press('Control+z');
  assert.equal(await rows(), 2);
  await page.keyboard.press('Control+z');
  assert.equal(await rows(), 1);
  await page.keyboard.press('Control+y');
  await page.keyboard.press('Control+y');
  assert.equal(await rows(), 2);
});

test('the form says what the part is', async () => {
  await page.getByRole('button', { name: /select part 1,/ }).click();
  await page.getByLabel('Situation').selectOption('underfeed');
  await page.getByLabel('Rods').fill('3');
  await page.getByLabel('Rods').press('Tab');
  await page.getByLabel('Rock').fill('hard');
  await page.getByLabel('Rock').press('Tab');
  await page.locator('.parts').getByText('Underfeed').waitFor();
  await photograph(page, 'annotate');
});

test('by keys alone: cursor, new part, its end, removed', async () => {
  await page.locator('main').focus();
  await page.keyboard.press('Home');
  for (let n = 0; n < 20; ++n) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('n');
  assert.equal(await rows(), 3);
  for (let n = 0; n < 3; ++n) await page.keyboard.press('ArrowRight');
  await page.keyboard.press(']');
  const from = Number(await page.getByLabel('From, s').inputValue()), to = Number(await page.getByLabel('To, s').inputValue());
  assert.ok(Math.abs(to - from - 0.6) < 0.01, `${from} ${to}`);
  await page.keyboard.press('Delete');
  assert.equal(await rows(), 2);
});

test('suggestions come with progress, and are accepted or rejected', async () => {
  await page.keyboard.press('g');
  await page.getByText('40 %').waitFor();
  await photograph(page, 'annotate_suggesting');
  release();
  await page.getByText('Suggestion 1 of 2').waitFor();
  await photograph(page, 'annotate_suggested');
  await page.keyboard.press('a');
  assert.equal(await rows(), 3);
  await page.keyboard.press('x');
  await page.getByRole('button', { name: 'Suggest parts' }).waitFor();
});

test('what is saved is the label track, in order of time, by the version that was read', async () => {
  await page.keyboard.press('Control+s');
  await page.getByText('Saved beside normal.wav').waitFor();
  const { version: sent, parts } = written();
  assert.equal(sent, 'v1');
  assert.deepEqual(parts.map(({ situation }) => situation), ['underfeed', 'normal', 'overfeed']);
  assert.deepEqual({ rods: parts[0].rods, rock: parts[0].rock, rpm: parts[0].rpm }, { rods: 3, rock: 'hard', rpm: null });
  assert.ok(await page.getByRole('button', { name: 'Save' }).isDisabled());
});

test('a track that changed meanwhile is neither overwritten nor lost', async () => {
  conflict = true;
  await page.keyboard.press('n');
  await page.keyboard.press('Control+s');
  await page.getByText('changed elsewhere').waitFor();
  await photograph(page, 'annotate_conflict');
  conflict = false;
  await page.getByRole('button', { name: 'Keep mine' }).click();
  await page.getByText('Saved beside').waitFor();
  assert.equal(written().version, 'v9');
});

test('it plays, and zooms at 60 pictures a second or what the machine gives', async () => {
  await page.keyboard.press('0');
  await page.keyboard.press(' ');
  await page.waitForFunction(() => window.heard.sources.length > 0);
  await page.keyboard.press(' ');
  const spot = await at(6);
  await page.mouse.move(spot.x, spot.y);
  const frames = page.evaluate(() => new Promise((done) => {
    let count = 0;
    const began = performance.now(), step = () => { ++count; if (performance.now() - began < 2000) requestAnimationFrame(step); else done(count / 2); };
    requestAnimationFrame(step);
  }));
  for (let n = 0; n < 40; ++n) { await page.mouse.wheel(0, n < 20 ? -120 : 120); await page.waitForTimeout(25); }
  console.log(`pictures a second while zooming: ${(await frames).toFixed(0)}`);
});

test('it is accessible and its console quiet', async () => {
  await page.keyboard.press('0');
  assert.deepEqual(await complaints(page), []);
  assert.deepEqual(studio.problems.filter((line) => !line.includes('409')), []);
});
