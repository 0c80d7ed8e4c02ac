// The way of a recording to a refined bank, page by page, as a person goes it.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { loudnessThat, photograph } from './browser.mjs';
import { rigsound } from './places.mjs';
import { run } from './small_set.mjs';

const kWork_ms = 240000;

export const go = (page, id) => page.evaluate((to) => { location.hash = `#/${to}`; }, id);

/** Draws one part by keys and saves it. `shown`: the recording in the list; `beside`: the file it stands in. */
export const annotate = async (page, picture, { shown, beside, from, to, situation, rods }) => {
  await page.getByRole('combobox', { name: 'Recording' }).selectOption({ label: shown });
  await page.getByRole('button', { name: 'New part' }).click();
  await page.getByLabel('To, s').fill(String(to));
  await page.getByLabel('To, s').press('Tab');
  await page.getByLabel('From, s').fill(String(from));
  await page.getByLabel('From, s').press('Tab');
  await page.getByLabel('Situation').selectOption(situation);
  await page.getByLabel('Rods').fill(String(rods));
  await page.getByLabel('Rods').press('Tab');
  await page.waitForTimeout(1500);
  await photograph(page, `${picture}_annotate`);
  await page.getByRole('button', { name: 'Save' }).click();
  await page.getByText(`Saved beside ${beside}`).waitFor();
};

/** Runs the chain on the parts of every recording. */
export const analyse = async (page, picture, recordings) => {
  await go(page, 'analyse');
  for (const name of recordings) {
    await page.getByRole('combobox', { name: 'Recording' }).selectOption({ label: name });
    await page.getByLabel(/0:\d\d\.\d to/).first().waitFor();
    await page.getByRole('button', { name: 'Analyse', exact: true }).click();
  }
  await page.waitForFunction((count) => [...document.querySelectorAll('.progress [role=status]')].filter((each) => each.textContent === 'done').length === count,
    recordings.length, { timeout: kWork_ms });
  await photograph(page, `${picture}_analyse`);
};

/** Until it is seen the first bank is, or was. */
const choose = async (page, bank) => {
  await page.getByRole('button', { name: new RegExp(bank) }).click();
  await page.getByRole('heading', { name: bank }).waitFor();
};

/** Recorded, denoised and synthesised play side by side, as long as one another. */
export const compare = async (page, picture, bank) => {
  await go(page, 'compare');
  await choose(page, bank);
  await page.getByText('Third-octave levels').waitFor({ timeout: kWork_ms });
  await page.getByText('synthesised', { exact: true }).first().waitFor();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction(() => window.heard.sources.length >= 3 && window.heard.sources.at(-1).context.state === 'running');
  assert.equal(new Set(await page.evaluate(() => window.heard.sources.slice(-3).map(({ buffer }) => buffer.length))).size, 1);
  await photograph(page, `${picture}_compare`);
};

const resynthesised = (folder, bank) => {
  run(rigsound, 'resynth', join(folder, 'set/banks', bank), join(folder, 'bank.wav'), '--seconds', '2');
  return createHash('sha256').update(readFileSync(join(folder, 'bank.wav'))).digest('hex');
};

/** A saved decay changes what `resynth` plays of the set in `folder`, and the analysed values bring it back. */
export const refine = async (page, picture, folder, bank) => {
  const analysed = resynthesised(folder, bank);
  await go(page, 'refine');
  await choose(page, bank);
  await page.getByRole('slider', { name: 'Decay' }).fill('2', { timeout: kWork_ms });
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await loudnessThat(page, (found) => found > 1e-4);
  await page.getByRole('button', { name: 'Save' }).click();
  await page.getByText('Saved.').waitFor();
  await photograph(page, `${picture}_refine`);
  assert.notEqual(resynthesised(folder, bank), analysed);
  await page.getByRole('button', { name: 'Back to analysed' }).click();
  await page.getByText('Back at the analysed values').waitFor();
  assert.equal(resynthesised(folder, bank), analysed);
};

/** The name of the first bank of a situation. */
export const bankOf = (folder, situation) => readFileSync(join(folder, 'set/soundset.toml'), 'utf8').match(new RegExp(`name = "([^"]*)"\\s+situation = "${situation}"`))[1];
