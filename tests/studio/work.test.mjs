// Analyse and Live: what is sent, what is shown, and what stands there when something is missing.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { closeBrowser, complaints, openPage, photograph, until } from './browser.mjs';
import * as documents from './documents.mjs';
import { fakeServer } from './fake_server.mjs';
import { pages } from './places.mjs';

const kId = documents.recording.id;
const job = (state, more = {}) => ({ id: 'j1', kind: 'analyze', state, progress: 0.4, left_s: 12.5, done: [], result: null, error: null, ...more });
const made = { bank: 'normal_01500ms', situation: 'normal', rods: 2, feed_bar: 110, rate_hz: 41.9, clicks: 10, found: 190, level_db: -20.1, snr_db: 13, ltas_error_db: 0.6, ltas_denoised_error_db: 0.8, modulation_error_db: 1.1 };
const status = { rig: 'demo.toml', muted: false, audio: { playing: true, card: 'hw:0', xruns: 0, deadline_misses: 2 }, meters: { peak_db: -12, rms_db: -24, limiter_db: 0, lost_clicks: 0 },
  signals: { engine_rpm: { value: 1500, unit: 'r/min', validity: 'valid', word: '', refused: 0, clamped: 0 }, 'boom1.feed_pressure_bar': { value: 90, unit: 'bar', validity: 'valid', word: '', refused: 0, clamped: 0 },
    'boom1.rod_count': { value: 2, unit: '', validity: 'stale', word: '', refused: 3, clamped: 0 } },
  booms: { boom1: { situation: 'normal', hammering: true, feed_deviation: 0.1, rods: 2, rock: 0, impacts_wanted_hz: 41.9, impacts_made_hz: 41, banks: [{ name: 'normal_01500ms', share: 0.8 }, { name: 'overfeed_09000ms', share: 0.2 }],
    levels: { drill: { peak_db: -12, rms_db: -25 } }, mean_frequency_hz: 0, mean_amplitude_db: 0, deviation_time: 1, deviation_amplitude: 1, attack_factor: 1, decay_factor: 1 } } };

let server, studio, page, release, tellLive;
const lastPost = (path) => JSON.parse(server.asked.filter((each) => each.method !== 'GET' && each.path === path).at(-1).body);
before(async () => {
  server = await fakeServer(pages, {
    'GET /state': { ...documents.withRecording, daemon: true }, 'GET /sound_set': documents.withBanks, 'GET /rig': documents.rig,
    'GET /banks/': ({ path }) => documents.bank(path.split('/').pop()),
    [`GET /recordings/${kId}/labels`]: { version: 'v1', parts: [documents.part(1.5, 6), documents.part(9, 12, { situation: 'overfeed' })], problems: [] },
    'GET /jobs': { jobs: [] }, 'POST /jobs': { id: 'j1' }, 'DELETE /jobs/j1': () => { release(); return job('stopped'); }, 'GET /jobs/j1': () => job('stopped', { done: ['normal_01500ms'], result: { banks: [made], failures: [], warnings: ['overfeed_09000ms: few clicks'] } }),
    'GET /jobs/j1/events': ({ response }) => { response.write(`${JSON.stringify(job('running', { done: ['normal_01500ms'] }))}\n`); release = () => response.end(); },
    'GET /live/events': ({ response }) => { tellLive = (line) => response.write(`${JSON.stringify(line)}\n`); tellLive({ event: 'change', uptime_s: 7, missed: 0, change: status }); },
    'POST /live': ({ body }) => (body.command === 'status' ? { ok: true, audio: { load: 0.021 }, signals: [{ name: 'engine_rpm', age_s: 0.04 }, { name: 'boom1.rod_count', age_s: 7.5 }] } : { ok: true }) });
  studio = await openPage(server.address, { at: 'analyse' });
  page = studio.page;
  await page.getByRole('link', { name: 'Analyse' }).waitFor();
});
after(async () => { await closeBrowser(); await server?.stop(); });
const go = (id) => page.evaluate((to) => { location.hash = `#/${to}`; }, id);

test('Analyse: chosen parts are sent, a finished bank is seen while the rest goes on, and it can be stopped', async () => {
  await go('analyse');
  await page.getByLabel(/0:09.0 to/).uncheck();
  await photograph(page, 'analyse');
  await page.getByRole('button', { name: 'Analyse', exact: true }).click();
  await page.getByText('40 %, 0:13 left').waitFor();
  await page.getByText('Third-octave levels').waitFor();
  assert.deepEqual(lastPost('/jobs'), { kind: 'analyze', recording: kId, parts: [{ from_s: 1.5, to_s: 6 }], clicks: 10, method: 'click-nmf' });
  await photograph(page, 'analyse_running');
  await page.getByRole('button', { name: 'Stop normal.wav' }).click();
  await page.getByText('stopped', { exact: true }).waitFor();
  await page.getByText('few clicks').waitFor();
  await photograph(page, 'analyse_done');
  assert.deepEqual(await complaints(page), []);
});

test('Live: signals with ages, changes as they come, controls go out', async () => {
  await go('live');
  await page.getByText('41.0 impacts a second').waitFor();
  await page.getByText('7.5 s').waitFor();
  tellLive({ event: 'change', uptime_s: 8, missed: 0, change: { booms: { boom1: { situation: 'overfeed', banks: [{ name: 'overfeed_09000ms', share: 1 }] } }, signals: { engine_rpm: { value: 1620 } } } });
  await page.locator('.situation').getByText('Overfeed').waitFor();
  await page.getByText('1620 r/min').waitFor();
  await page.getByRole('slider', { name: 'Decay' }).fill('2');
  const sets = () => server.asked.filter(({ path, body }) => path === '/live' && body.includes('"set"'));
  await until('nothing set', () => sets().length > 0);
  assert.deepEqual(JSON.parse(sets().at(-1).body), { command: 'set', key: 'boom1.decay_factor', value: 2 });
  await page.locator('main').focus();
  await page.keyboard.press('m');
  await until('not muted', () => server.asked.some(({ body }) => body === '{"command":"mute","on":true}'));
  await photograph(page, 'live');
  tellLive({ event: 'gone', error: 'the socket was closed' });
  await page.getByText('The daemon is gone').waitFor();
  await photograph(page, 'live_gone');
  assert.deepEqual(await complaints(page), []);
});

test('without recordings, banks, backgrounds or a daemon every page says what to do', async () => {
  server.routes['GET /state'] = documents.state;
  server.routes['GET /sound_set'] = documents.soundSet;
  for (const [id, words] of [['annotate', 'There are no recordings'], ['analyse', 'There are no recordings'], ['compare', 'no banks yet'], ['refine', 'no banks yet'],
    ['diesel', 'no diesel yet'], ['live', 'No daemon is connected']]) {
    await go(id);
    await page.getByText(words).waitFor();
    await photograph(page, `empty_${id}`);
  }
  assert.deepEqual(studio.problems, []);
});
