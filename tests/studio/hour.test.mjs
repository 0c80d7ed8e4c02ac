// A recording of an hour on the Annotate page: how soon it is seen, and how smoothly it is zoomed. Figures, no verdicts: what is
// asserted is that something is seen.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { closeBrowser, openPage, photograph } from './browser.mjs';
import { here } from './places.mjs';
import { run } from './small_set.mjs';
import { startStudio } from './studio_program.mjs';

let folder, studio;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'rigsound_hour.'));
  mkdirSync(join(folder, 'recordings'));
  run('python3', '-c', `import sys; sys.path.insert(0, ${JSON.stringify(join(here, '../cli'))}); import sound_files as s; s.write_long_wav(sys.argv[1], s.drilling(), 3600)`, join(folder, 'recordings/hour.wav'));
  studio = await startStudio(join(folder, 'set'), '--recordings', join(folder, 'recordings'));
});
after(async () => { await closeBrowser(); await studio?.stop(); rmSync(folder, { recursive: true, force: true }); });

/** Milliseconds since the page was asked for until the middle of its spectrogram has a colour. */
const seen = (page) => page.evaluate(async () => {
  for (;;) {
    const canvas = document.querySelector('.sonagram canvas');
    if (canvas?.width > 100) {
      const { data } = canvas.getContext('2d').getImageData(canvas.width / 2, canvas.height / 2, 1, 1);
      if (data[3] > 0) return performance.now();
    }
    await new Promise(requestAnimationFrame);
  }
});

/** Turns the wheel a little before every frame for some seconds: how long the frames were, ms. */
const zoomed = (page, towards) => page.evaluate(async (deltaY) => {
  const canvas = document.querySelector('.sonagram canvas'), box = canvas.getBoundingClientRect(), all = [];
  for (let last = await new Promise(requestAnimationFrame), end = last + 2500; last < end;) {
    canvas.dispatchEvent(new WheelEvent('wheel', { deltaY, clientX: box.x + 0.4 * box.width, clientY: box.y + 60, bubbles: true, cancelable: true }));
    const now = await new Promise(requestAnimationFrame);
    all.push(now - last);
    last = now;
  }
  return all;
}, towards);
const seconds = (text) => text.split(':').reduce((sum, part) => 60 * sum + Number(part), 0);
const shown = async (page) => {
  const [, from, to] = (await page.getByText(/ to .* of /).textContent()).match(/([\d:.]+) to ([\d:.]+) of/);
  return seconds(to) - seconds(from);
};

test('it is seen, whether the program has met it or not', async () => {
  for (const what of ['first time', 'again']) {
    const opened = await openPage(studio.address, { at: 'annotate' });
    console.log(`an hour is seen ${(await seen(opened.page)).toFixed(0)} ms after the page was asked for, ${what}`);
    await photograph(opened.page, `hour_${what.replace(' ', '_')}`);
    assert.deepEqual(opened.problems, []);
    await opened.close();
  }
});

test('it is zoomed to a second and back', async () => {
  const { page, close } = await openPage(studio.address, { at: 'annotate' });
  await seen(page);
  const whole = await shown(page);
  assert.ok(whole > 3590, String(whole));
  for (const [towards, what] of [[-60, 'in'], [60, 'out']]) {
    const frames = (await zoomed(page, towards)).sort((a, b) => a - b);
    console.log(`zooming ${what}: ${(1000 * frames.length / frames.reduce((sum, ms) => sum + ms, 0)).toFixed(1)} frames a second, ` +
      `median ${frames[frames.length >> 1].toFixed(1)} ms, longest ${frames.at(-1).toFixed(1)} ms; ${(await shown(page)).toFixed(1)} s are shown`);
    if (what === 'in') {
      assert.ok(await shown(page) < 60);
      await page.waitForTimeout(1500);
      await photograph(page, 'hour_zoomed');
    }
  }
  await close();
});
