// The Listen page with the program's own server: both tests from beginning to end by keys alone, blind, and what lies on disk.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, openPage, photograph } from './browser.mjs';
import { recordedSet } from './recorded_set.mjs';
import { startStudio } from './studio_program.mjs';

const kKinds = ['recorded', 'denoised', 'synthesised', 'anchor'];
let made, studio, opened, page;
/** Requests and answers of trials, in their order; of sounds the number of octets. */
const talk = [];
const record = () => page.on('request', async (request) => {
  const path = new URL(request.url()).pathname.replace('/api/v1', ''), entry = { method: request.method(), path };
  if (!path.startsWith('/listen/trials')) return;
  talk.push(entry);
  const octets = await (await request.response()).body();
  entry.octets = octets.length;
  if (!path.includes('/sounds/')) entry.answer = JSON.parse(octets.toString());
});
before(async () => {
  made = recordedSet();
  studio = await startStudio(made.set, '--recordings', made.recordings);
  opened = await openPage(studio.address);
  page = opened.page;
  record();
  await page.getByRole('link', { name: 'Listen' }).waitFor();
});
after(async () => { await closeBrowser(); await studio?.stop(); made?.end(); });

/** Tab until what has the focus bears the name. */
const tabTo = async (name) => {
  for (let n = 0; n < 60; ++n) {
    await page.keyboard.press('Tab');
    const named = await page.evaluate(() => {
      const at = document.activeElement;
      return at?.getAttribute('aria-label') ?? at?.labels?.[0]?.textContent ?? at?.textContent ?? '';
    });
    if (named.trim() === name || (name instanceof RegExp && name.test(named))) return;
  }
  assert.fail(`${name} is not reached with Tab`);
};
/** What the page shows, without the number of the trial. */
const shown = async () => (await page.locator('main').evaluate((main) => main.outerHTML)).replace(/Trial \d+ of \d+/, 'Trial').replace(/field-\d+/g, 'field');
const openedTrials = () => talk.filter(({ method }) => method === 'POST').map(({ answer }) => answer.id);
const of = (id) => talk.filter(({ path }) => path.includes(id));

/** Nothing that the page was told or shows before the answer differs from trial to trial. */
const staysBlind = (views) => {
  assert.equal(new Set(views).size, 1, 'the page looks the same in every trial');
  for (const word of kKinds) assert.ok(!views[0].toLowerCase().includes(word), word);
  const ids = openedTrials();
  for (const id of ids) {
    const asked = of(id), end = asked.findIndex(({ method }) => method === 'DELETE'), before_ = end < 0 ? asked : asked.slice(0, end);
    // The order of the requests says nothing: it is that of the places.
    assert.deepEqual(before_.map(({ path }) => path.split('/').pop()), talk.find(({ answer }) => answer?.id === id).answer.sounds);
    assert.equal(new Set(before_.map(({ octets }) => octets)).size, 1);
  }
  assert.equal(new Set(talk.filter(({ method }) => method === 'POST').map(({ answer }) => Object.keys(answer).join())).size, 1);
  assert.equal(new Set(ids).size, ids.length);
};
const saved = async () => {
  const words = await page.getByText('Saved with the sound set').textContent();
  const file = join(made.set, /listening\/\S+\.csv/.exec(words)[0]);
  assert.ok(existsSync(file), file);
  return readFileSync(file, 'utf8').trim().split('\n').map((row) => row.split(','));
};

test('ABX by keys alone: practice, trials, a break, the result and its file; nothing tells X', async () => {
  await tabTo(/^Listen/);
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Begin', exact: true }).waitFor();
  await photograph(page, 'listen');
  assert.deepEqual(await complaints(page), []);
  await tabTo('Trials');
  await page.keyboard.press('Control+a');
  await page.keyboard.type('13');
  await tabTo('Listener');
  await page.keyboard.type('N. N.');
  await tabTo('Begin');
  await page.keyboard.press('Enter');
  const views = [];
  for (let n = 0; n <= 13; ++n) {
    await page.getByRole('heading', { name: n === 0 ? 'Practice' : `Trial ${n} of 13` }).waitFor();
    await page.keyboard.press('ArrowLeft');
    assert.ok(await page.getByRole('button', { name: 'X is A' }).isDisabled());
    for (const key of ['a', 'b', 'x']) await page.keyboard.press(key);
    if (n > 0) views.push(await shown());
    if (n === 1) {
      await photograph(page, 'listen_abx');
      assert.deepEqual(await complaints(page), []);
    }
    await page.keyboard.press(n % 2 ? 'ArrowLeft' : 'ArrowRight');
    if (n === 0) {
      await page.getByText(/^X was [AB]\./).waitFor();
      await photograph(page, 'listen_practice');
      await page.keyboard.press('Enter');
    }
    if (n === 12) {
      await page.getByRole('heading', { name: 'A break' }).waitFor();
      await photograph(page, 'listen_break');
      await page.keyboard.press('Enter');
    }
  }
  const [head, ...rows] = await saved();
  await photograph(page, 'listen_abx_result');
  assert.deepEqual(await complaints(page), []);
  staysBlind(views);
  assert.deepEqual(head.slice(0, 10), ['test', 'listener', 'trial', 'bank', 'training', 'a', 'b', 'x', 'answer', 'right']);
  assert.deepEqual(rows.map((row) => row[2]), Array.from({ length: 14 }, (_, n) => String(n)));
  // What was noted is what the server says the sounds were.
  const told = Object.fromEntries(talk.filter(({ method }) => method === 'DELETE').map(({ answer }, n) => [n, answer.sounds]));
  rows.forEach((row, n) => {
    assert.deepEqual(row.slice(5, 8), [told[n].a, told[n].b, told[n].x]);
    assert.equal(row[8], told[n][n % 2 ? 'a' : 'b']);
    assert.equal(row[9], String(Number(row[7] === row[8])));
    assert.equal(row[1], 'N. N.');
  });
  const right = rows.slice(1).filter((row) => row[9] === '1').length;
  await page.getByRole('heading', { name: `${right} of 13 right` }).waitFor();
});

test('rating by keys alone: every sound heard and scored, the result and its file', async () => {
  talk.length = 0;
  await tabTo('Another test');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Begin', exact: true }).waitFor();
  await tabTo(/^ABX/);
  await page.keyboard.press('ArrowRight');
  await tabTo(/^Begin with a trial/);
  await page.keyboard.press('Space');
  await tabTo('Begin');
  await page.keyboard.press('Enter');
  const views = [], scores = [];
  for (let n = 1; n <= 6; ++n) {
    await page.getByRole('heading', { name: `Trial ${n} of 6` }).waitFor();
    await page.keyboard.press('r');
    views.push(await shown());
    scores.push([]);
    for (const key of ['a', 'b', 'c', 'd']) {
      await page.keyboard.press(key);
      // The arrows move the score of what is heard; Page Up makes ten of it.
      for (let up = 0; up < (n + key.charCodeAt(0)) % 9 + 1; ++up) await page.keyboard.press('PageUp');
      for (let up = 0; up < n; ++up) await page.keyboard.press('ArrowUp');
      scores.at(-1).push(Number(await page.evaluate(() => document.activeElement.value)));
    }
    if (n === 1) {
      await photograph(page, 'listen_rating');
      assert.deepEqual(await complaints(page), []);
    }
    await page.keyboard.press('Enter');
  }
  await page.getByRole('heading', { name: 'Ratings' }).waitFor();
  const [, ...rows] = await saved();
  await photograph(page, 'listen_rating_result');
  assert.deepEqual(await complaints(page), []);
  staysBlind(views);
  assert.equal(rows.length, 24);
  const told = talk.filter(({ method }) => method === 'DELETE').map(({ answer }) => answer.sounds);
  assert.deepEqual(rows.map((row) => [row[10], row[11]]), told.flatMap((sounds, n) => ['1', '2', '3', '4'].map((place, i) => [sounds[place], String(scores[n][i])])));
  // The median of six as anybody counts it; their interval of 95 % goes from the least to the most.
  for (const kind of kKinds) {
    const mine = rows.filter((row) => row[10] === kind).map((row) => Number(row[11])).sort((a, b) => a - b), cells = page.getByRole('row', { name: new RegExp(`^${kind} `) }).getByRole('cell');
    assert.equal(Number(await cells.nth(1).textContent()), (mine[2] + mine[3]) / 2);
    assert.equal(await cells.nth(2).textContent(), `${mine[0]} to ${mine[5]}`);
  }
});

test('earlier tests are shown together', async () => {
  await page.getByRole('button', { name: 'Another test' }).click();
  const files = page.getByRole('group', { name: 'Earlier tests' }).getByRole('checkbox');
  await files.first().waitFor();
  assert.equal(await files.count(), 2);
  for (let n = 0; n < 2; ++n) await files.nth(n).check();
  await photograph(page, 'listen_earlier');
  await page.getByRole('button', { name: 'Show results' }).click();
  await page.getByRole('heading', { name: 'Ratings' }).waitFor();
  await page.getByRole('heading', { name: /of 13 right/ }).waitFor();
  assert.deepEqual(await complaints(page), []);
  assert.deepEqual(opened.problems, []);
});
