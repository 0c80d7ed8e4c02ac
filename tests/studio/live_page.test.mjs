// The Live page beside a running daemon on the null card that is told, over UDP, what the bus log of a shift says.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import dgram from 'node:dgram';
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, openPage, photograph } from './browser.mjs';
import { rigsound, rigsoundd, root } from './places.mjs';
import { run, smallSet } from './small_set.mjs';
import { startStudio } from './studio_program.mjs';

const kSituations = { normal: 'Normal', underfeed: 'Underfeed', overfeed: 'Overfeed', closed_rattling: 'Closed rattling', open_rattling: 'Open rattling' };
const kSendEvery_ms = 40;
let set, socket, daemon, studio, opened, page, timeline, mouth, sending, values = {};

const place = (...words) => join(set.folder, ...words);
const startDaemon = async () => {
  daemon = spawn(rigsoundd, [place('live.toml')], { stdio: 'ignore' });
  for (;;) {
    try { return run(rigsound, 'ctl', '--socket', socket, 'status', '--json'); } catch (error) {
      assert.equal(daemon.exitCode, null, String(error));
      await new Promise((done) => setTimeout(done, 100));
    }
  }
};
const status = () => JSON.parse(run(rigsound, 'ctl', '--socket', socket, 'status', '--json'));
const freePort = () => new Promise((done) => {
  const probe = dgram.createSocket('udp4');
  probe.bind(0, '127.0.0.1', () => { const { port } = probe.address(); probe.close(() => done(port)); });
});
/** The value that changes of a lane have at a time of the log. */
const valueAt = (changes, time_s) => changes.reduce((value, [at_s, next]) => (at_s <= time_s ? next : value), null);
/** From now on the daemon is told, again and again, what the log says at `time_s`. */
const goTo = (time_s) => {
  values = Object.fromEntries(timeline.signals.filter(({ boom }) => boom === '').map(({ name, changes }) => [name, valueAt(changes, time_s)]).filter(([, value]) => value !== null));
};

before(async () => {
  set = smallSet();
  socket = place('control');
  mkdirSync(place('recordings'));
  copyFileSync(join(root, 'config/logs/shift.log'), place('recordings/shift.log'));
  const port = await freePort();
  writeFileSync(place('live.toml'), `[audio]\ndevice = "null"\n[sound]\nset = "sounds"\n[control]\nsocket = "${socket}"\n[[udp]]\naddress = "127.0.0.1:${port}"\n`);
  writeFileSync(place('demo.toml'), readFileSync(join(root, 'config/rigs/demo.toml'), 'utf8').replace('"../../out/soundset"', '"sounds"')
    .replaceAll('"../dbc/', `"${join(root, 'config/dbc')}/`).replace(/^tool = "rods"/m, '#'));
  await startDaemon();
  studio = await startStudio(place('sounds'), '--recordings', place('recordings'), '--rig', place('demo.toml'), '--daemon', socket);
  const { origin, hash } = new URL(studio.address), ask = async (path) => (await fetch(`${origin}/api/v1${path}`, { headers: { 'X-Rigsound-Token': hash.slice(1) } })).json();
  const known = new Set((await ask('/rig')).signals.map(({ name }) => name)), { logs: [{ id }] } = await ask('/state');
  timeline = await ask(`/logs/${id}/timeline`);
  timeline.signals = timeline.signals.filter(({ name }) => known.has(name));
  mouth = dgram.createSocket('udp4');
  goTo(0);
  sending = setInterval(() => mouth.send(JSON.stringify(values), port, '127.0.0.1'), kSendEvery_ms);
  opened = await openPage(studio.address, { at: 'live' });
  page = opened.page;
  await page.getByRole('heading', { name: 'Signals' }).waitFor();
});
after(async () => {
  clearInterval(sending);
  mouth?.close();
  await closeBrowser();
  await studio?.stop();
  daemon?.kill('SIGKILL');
  set?.end();
});

const feedShown = (bar) => page.getByRole('row', { name: /^feed_pressure_bar / }).getByText(`${+bar.toFixed(2)} bar`, { exact: true }).waitFor();

test('it follows the shift: situations, values, impacts', async () => {
  const { changes } = timeline.situations.find(({ boom }) => boom === ''), seen = new Set();
  const hammers = (time_s) => valueAt(timeline.signals.find(({ name }) => name === 'percussion').changes, time_s) === 1;
  await page.locator('.situation').getByText('Hammer rests').waitFor();
  // Second by second, until each situation was met in which the hammer strikes.
  for (let at_s = 0; at_s < timeline.seconds; ++at_s) {
    const situation = valueAt(changes, at_s);
    if (!kSituations[situation] || seen.has(situation) || !hammers(at_s)) continue;
    seen.add(situation);
    goTo(at_s);
    await page.locator('.situation').getByText(kSituations[situation], { exact: true }).waitFor();
    await feedShown(values.feed_pressure_bar);
    if (situation === 'normal') await photograph(page, 'live_shift');
  }
  console.log(`situations of the shift that were followed: ${[...seen].join(' ')}`);
  assert.ok(['normal', 'underfeed', 'overfeed'].every((situation) => seen.has(situation)), [...seen].join(' '));
  await page.locator('.situation').getByText(/impacts a second/).waitFor();
  assert.deepEqual(await complaints(page), []);
});

test('mute and controls of the page reach the daemon', async () => {
  await page.locator('main').focus();
  await page.keyboard.press('m');
  await page.getByRole('button', { name: 'Unmute' }).waitFor();
  assert.equal(status().muted, true);
  await photograph(page, 'live_muted');
  await page.keyboard.press('m');
  await page.getByRole('button', { name: 'Mute', exact: true }).waitFor();
  assert.equal(status().muted, false);
  await page.getByRole('slider', { name: 'Decay' }).fill('2');
  // The daemon's word comes round to the page as it would to a second one.
  const second = await openPage(studio.address, { at: 'live' });
  await second.page.waitForFunction(() => [...document.querySelectorAll('input[type=range]')].some((each) => each.value === '2'));
  await second.close();
  await page.getByRole('button', { name: 'Release all' }).click();
});

test('a daemon that is killed is told, and followed again when it is back', async () => {
  daemon.kill('SIGKILL');
  await page.getByText('The daemon is gone').waitFor();
  await photograph(page, 'live_killed');
  assert.deepEqual(await complaints(page), []);
  await startDaemon();
  const lane = timeline.signals.find(({ name }) => name === 'feed_pressure_bar'), highest = lane.changes.reduce((most, change) => ((change[1] ?? 0) > most[1] ? change : most), [0, 0]);
  goTo(highest[0]);
  await feedShown(highest[1]);
  await page.waitForFunction(() => !document.querySelector('.note').textContent.includes('gone'));
  // The browser itself says that an answer was 503.
  assert.deepEqual(opened.problems.filter((line) => !line.includes('503')), []);
});
