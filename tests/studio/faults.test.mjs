// Strangers, links, two tabs, a killed program and a full disk, as a person with a browser meets them at the program itself.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import http from 'node:http';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, openPage, photograph } from './browser.mjs';
import { failingCalls } from './places.mjs';
import { smallSet } from './small_set.mjs';
import { tone } from './sounds.mjs';
import { startStudio, startStudioIn } from './studio_program.mjs';

let set, studio;
const place = (...words) => join(set.folder, ...words);
const track = (name = 'a') => place('recordings', `${name}.txt`);
before(async () => {
  set = smallSet();
  mkdirSync(place('recordings'));
  for (const name of ['recordings/a', 'recordings/b', 'secret']) writeFileSync(place(`${name}.wav`), tone(440, 8));
  symlinkSync(place('secret.wav'), place('recordings/link.wav'));
  symlinkSync(place('elsewhere.txt'), track('b'));
  studio = await startStudio(place('sounds'), '--recordings', place('recordings'));
});
after(async () => { await closeBrowser(); await studio?.stop(); set?.end(); });

const token = () => new URL(studio.address).hash.slice(1);
/** A part from one second to another, by the form. */
const addPart = async (page, from_s, to_s) => {
  await page.getByRole('button', { name: 'New part' }).click();
  for (const [label, value] of [['To, s', to_s], ['From, s', from_s]]) {
    await page.getByLabel(label).fill(String(value));
    await page.getByLabel(label).press('Tab');
  }
};
const openAnnotate = async (name = 'a') => {
  const opened = await openPage(studio.address, { at: 'annotate' });
  const recordings = opened.page.getByRole('combobox', { name: 'Recording' });
  await recordings.selectOption(await recordings.getByRole('option', { name: `${name}.wav` }).getAttribute('value'));
  return opened;
};
const saveSays = async (page, words) => {
  await page.getByRole('button', { name: 'Save' }).click();
  await page.getByText(words).waitFor();
};

test('who has no token, or a wrong one, is told where to get it', async () => {
  const { origin } = new URL(studio.address);
  for (const address of [`${origin}/`, `${origin}/#${'0'.repeat(32)}`]) {
    const { page, close } = await openPage(address);
    await page.getByText('no valid token').waitFor();
    await photograph(page, 'no_token');
    assert.deepEqual(await complaints(page), []);
    await close();
  }
});

test('the token stands in no address that a page asks for, nor in its own', async () => {
  const { page, close } = await openPage(studio.address), asked = [];
  page.on('request', (request) => asked.push(request.url()));
  await page.getByRole('button', { name: 'New part' }).waitFor();
  assert.ok(!page.url().includes(token()));
  assert.ok(asked.length > 0 && asked.every((url) => !url.includes(token())));
  await close();
});

test('a name that was turned to this machine is no way in', async () => {
  const { port } = new URL(studio.address), { page, close } = await openPage('about:blank');
  for (const path of ['/', '/app.js', '/api/v1/state']) assert.equal((await page.goto(`http://rebound.invalid:${port}${path}`)).status(), 403, path);
  await close();
});

test('another page reads nothing, writes nothing and shows nothing of it', async () => {
  const foreign = http.createServer((_, response) => { response.setHeader('Content-Type', 'text/html'); response.end('<!doctype html><title>foreign</title>'); });
  await new Promise((done) => foreign.listen(0, '127.0.0.1', done));
  const { origin } = new URL(studio.address), { page, close } = await openPage(`http://127.0.0.1:${foreign.address().port}/`);
  const tried = await page.evaluate(async ({ origin, token }) => {
    const headers = { 'X-Rigsound-Token': token, 'Content-Type': 'application/json' }, body = '{"csv": "from elsewhere"}';
    const outcome = (work) => work.then((answer) => `${answer.type} ${answer.status}`, () => 'refused');
    return Promise.all([outcome(fetch(`${origin}/api/v1/state`, { headers })), outcome(fetch(`${origin}/index.html`)),
      outcome(fetch(`${origin}/api/v1/listen/results`, { method: 'POST', headers, body })),
      outcome(fetch(`${origin}/api/v1/listen/results`, { method: 'POST', mode: 'no-cors', body }))]);
  }, { origin, token: token() });
  assert.deepEqual(tried, ['refused', 'refused', 'refused', 'refused']);
  assert.ok(!existsSync(place('sounds/listening')));
  await page.evaluate((address) => new Promise((done) => {
    const frame = document.createElement('iframe');
    frame.onload = done;
    frame.src = address;
    document.body.append(frame);
  }), `${origin}/`);
  assert.ok(!(await page.frames().at(-1).content()).includes('rigsound studio'));
  await close();
  foreign.close();
});

test('no path and no link leaves the folders', async () => {
  const { page, close } = await openAnnotate(), names = await page.getByRole('combobox', { name: 'Recording' }).getByRole('option').allTextContents();
  assert.deepEqual(names.map((name) => name.slice(0, 5)), ['a.wav', 'b.wav']);
  const statuses = await page.evaluate((secret) => Promise.all(['/..%2fsecret.wav', '/%2e%2e/secret.wav', '/....//secret.wav', '/api/v1/banks/..%2f..', '/api/v1/recordings/..%2f..%2fsecret/audio',
    '/api/v1/listen/results/..%2fsoundset.toml'].map(async (path) => (await fetch(path, { headers: { 'X-Rigsound-Token': secret } })).status)), token());
  assert.ok(statuses.every((status) => status === 403 || status === 404), statuses.join());
  await close();
  // A label track that is a link out of the folder is neither shown nor written through.
  const linked = await openAnnotate('b');
  await linked.page.getByRole('heading', { name: 'That did not work' }).waitFor();
  await photograph(linked.page, 'annotate_link');
  assert.ok(!existsSync(place('elsewhere.txt')));
  await linked.close();
});

test('of two tabs the second to save is told, and nothing of either is lost', async () => {
  const [first, second] = [await openAnnotate(), await openAnnotate()];
  await addPart(first.page, 1, 3);
  await addPart(second.page, 4, 6);
  await saveSays(first.page, 'Saved beside a.wav');
  await saveSays(second.page, 'changed elsewhere');
  await photograph(second.page, 'two_tabs');
  assert.match(readFileSync(track(), 'utf8'), /^1\.0/);
  assert.equal(await second.page.locator('.parts tbody tr').count(), 1);
  await second.page.getByRole('button', { name: 'Keep mine' }).click();
  await second.page.getByText('Saved beside a.wav').waitFor();
  assert.match(readFileSync(track(), 'utf8'), /^4\.0/);
  assert.match(readFileSync(`${track()}.bak`, 'utf8'), /^1\.0/);
  await first.close();
  await second.close();
});

test('a program that was killed is told; its next one takes what was drawn meanwhile', async () => {
  const { page, close } = await openAnnotate(), { port } = new URL(studio.address), rows = 1;
  // What the second tab kept.
  await page.locator('.parts tbody tr').first().waitFor();
  await studio.kill();
  await addPart(page, 6.5, 7.5);
  await page.getByRole('button', { name: 'Save' }).click();
  await page.getByRole('alert').getByText(`--port ${port}`).waitFor();
  await photograph(page, 'killed');
  assert.deepEqual(await complaints(page), []);
  studio = await startStudio(place('sounds'), '--recordings', place('recordings'), '--port', port);
  await page.getByRole('alert').getByText('started anew').waitFor();
  await photograph(page, 'started_anew');
  // As if the printed address were put into the tab.
  await page.evaluate((hash) => { location.hash = hash; }, new URL(studio.address).hash);
  await page.locator('.banner').waitFor({ state: 'detached' });
  assert.ok(!page.url().includes(token()));
  assert.equal(await page.locator('.parts tbody tr').count(), rows + 1);
  await saveSays(page, 'Saved beside a.wav');
  assert.match(readFileSync(track(), 'utf8'), /^6\.50*\t7\.50*/m);
  await close();
});

test('a full disk is told, leaves the file as it was, and is tried again', async () => {
  await studio.stop();
  studio = await startStudioIn({ LD_PRELOAD: failingCalls, RIGSOUND_FAULT: `${place('recordings')} write 1` }, place('sounds'), '--recordings', place('recordings'));
  const { page, close } = await openAnnotate(), kept = readFileSync(track(), 'utf8');
  await page.locator('.parts tbody tr').first().waitFor();
  await addPart(page, 0.2, 0.8);
  await saveSays(page, /No space left/);
  await photograph(page, 'full_disk');
  assert.equal(readFileSync(track(), 'utf8'), kept);
  await saveSays(page, 'Saved beside a.wav');
  assert.match(readFileSync(track(), 'utf8'), /^0\.2/);
  assert.equal(readFileSync(`${track()}.bak`, 'utf8'), kept);
  await close();
});
