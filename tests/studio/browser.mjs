// Chromium for tests of the studio: one browser a test program, every page with what the tests look through.
import { mkdir } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { output, packages } from './places.mjs';

const modules = createRequire(join(packages, 'package.json'));
const kChromium = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find(existsSync);
const kFlags = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  // A name that leads to this machine, as a page that wants to reach it would have.
  '--host-resolver-rules=MAP rebound.invalid 127.0.0.1', '--disable-component-update', '--disable-sync', '--autoplay-policy=no-user-gesture-required'];

const kPatience_ms = 180000;

let browser = null;

// Every audio node that a page makes, so that a test can listen at it. Runs before the page's own script.
const keepNodes = () => {
  const Node = window.AudioWorkletNode;
  window.heard = { nodes: [], sources: [] };
  const keep = (list, node) => { if (node.context instanceof AudioContext) list.push(node); };
  window.AudioWorkletNode = class extends Node {
    constructor(...words) { super(...words); keep(window.heard.nodes, this); this.madeWith = words[2]?.processorOptions; }
  };
  const Source = window.AudioBufferSourceNode;
  window.AudioBufferSourceNode = class extends Source {
    constructor(...words) { super(...words); keep(window.heard.sources, this); }
  };
};

/** A page at 1280x800, `at` one of the studio's; `problems` collects what its console complains of. */
export const openPage = async (address, { at = '', dark = false, width = 1280, height = 800, zoom = 1 } = {}) => {
  browser ??= await modules('playwright-core').chromium.launch({ executablePath: kChromium, args: kFlags });
  const context = await browser.newContext({ viewport: { width: Math.round(width / zoom), height: Math.round(height / zoom) }, deviceScaleFactor: zoom,
    colorScheme: dark ? 'dark' : 'light', acceptDownloads: true });
  // No test waits for less than what a busy machine may need.
  context.setDefaultTimeout(kPatience_ms);
  const page = await context.newPage(), problems = [];
  page.on('console', (message) => { if (message.type() === 'error') problems.push(message.text()); });
  page.on('pageerror', (error) => problems.push(String(error)));
  await page.addInitScript(keepNodes);
  const { origin, hash } = new URL(address);
  if (at) await page.addInitScript((token) => sessionStorage.setItem('rigsound-token', token), hash.slice(1));
  await page.goto(at ? `${origin}/#/${at}` : address);
  return { page, problems, close: () => context.close() };
};

export const closeBrowser = async () => { await browser?.close(); browser = null; };

/** Both themes of what a page shows, kept as test output. */
export const photograph = async (page, name) => {
  await mkdir(output, { recursive: true });
  for (const scheme of ['dark', 'light']) {
    await page.emulateMedia({ colorScheme: scheme });
    await page.waitForTimeout(120);
    await page.screenshot({ path: join(output, `${name}_${scheme}.png`) });
  }
};

/** Serious findings of axe-core, as lines. */
export const complaints = async (page) => {
  await page.evaluate(modules('axe-core').source);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
  return violations.filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(' ')}: ${node.failureSummary.split('\n')[1] ?? ''}`));
};

/** What `find` gives once it is true of it; a busy machine has all the time that it needs. */
export const until = async (what, find) => {
  for (const end = Date.now() + kPatience_ms; ;) {
    const found = await find();
    if (found) return found;
    if (Date.now() > end) throw new Error(`${what} within ${kPatience_ms / 1000} s`);
    await new Promise((done) => setTimeout(done, 50));
  }
};

/** Root mean square of `seconds` of what the newest engine of the page plays. */
export const loudness = (page, seconds = 0.4) => page.evaluate(async (length) => {
  const node = window.heard.nodes.at(-1), analyser = node.context.createAnalyser();
  analyser.fftSize = 2048;
  node.connect(analyser);
  const x = new Float32Array(2048);
  let square = 0, count = 0;
  for (const end = performance.now() + 1000 * length; performance.now() < end; ++count) {
    await new Promise((done) => setTimeout(done, 40));
    analyser.getFloatTimeDomainData(x);
    square += x.reduce((sum, v) => sum + v * v, 0) / x.length;
  }
  node.disconnect(analyser);
  return Math.sqrt(square / count);
}, seconds);

/** The loudness of the newest engine once it is as `fits` wants it. */
export const loudnessThat = (page, fits) => until('no such loudness', async () => {
  const found = await loudness(page);
  return fits(found) && found;
});
/** `seconds` of what the newest engine of the page plays, from now on, at the context's rate; at most 0.68 s at 48 kHz. */
export const samples = (page, seconds) => page.evaluate(async (length) => {
  const node = window.heard.nodes.at(-1), analyser = node.context.createAnalyser();
  analyser.fftSize = 32768;
  node.connect(analyser);
  await new Promise((done) => setTimeout(done, 1000 * length));
  const x = new Float32Array(32768);
  analyser.getFloatTimeDomainData(x);
  node.disconnect(analyser);
  return { rate: node.context.sampleRate, x: [...x.slice(-Math.round(length * node.context.sampleRate))] };
}, seconds);

/** Power of `hz` in samples, Hann window, dB. */
export const powerAt = ({ rate, x }, hz) => {
  let re = 0, im = 0;
  x.forEach((v, n) => {
    const window = 0.5 - 0.5 * Math.cos(2 * Math.PI * n / x.length), angle = 2 * Math.PI * hz * n / rate;
    re += window * v * Math.cos(angle);
    im += window * v * Math.sin(angle);
  });
  return 10 * Math.log10((re * re + im * im) / (x.length * x.length) + 1e-30);
};

/** Whether a page fits its window in widths that people have, a magnified one among them; leaves 1280x800. */
export const widths = async (page, name) => {
  const tooWide = [];
  for (const [width, height] of [[1280, 800], [640, 400], [3840, 2160]]) {
    await page.setViewportSize({ width, height });
    await page.waitForTimeout(100);
    if (!await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth)) tooWide.push(width);
    await photograph(page, `${name}_${width}`);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  return tooWide;
};
