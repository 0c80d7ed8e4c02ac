// One trial of ratings after ITU-R BS.1534: an open reference, and hidden among the rated sounds the reference again and its
// 3.5 kHz anchor.
import { h } from '../dom/element';
import { button, slider } from '../dom/fields';
import type { Trial } from './abx_trial';
import { shuffled } from './shuffle';
import { trialPlayer, type Kind } from './trial_sounds';

export const kRated: readonly Kind[] = ['recorded', 'denoised', 'synthesised', 'anchor'];
export type Scores = { sound: Kind; score: number }[];

export const ratingTrial = async (bank: string, title: string): Promise<Trial<Scores>> => {
  const player = await trialPlayer(bank, kRated), order = shuffled(kRated);
  let given: (scores: Scores) => void = () => undefined;
  const answer = new Promise<Scores>((resolve) => { given = resolve; });
  const scores = new Map<number, number>(), heard = new Set<number>(), hearing: HTMLButtonElement[] = [];
  const hear = (n: number): void => {
    const kind = n < 0 ? 'recorded' : order[n] as Kind;
    player.choose(kind);
    if (!player.playing) player.play();
    if (n >= 0) heard.add(n);
    [reference, ...hearing].forEach((each, i) => each.setAttribute('aria-pressed', String(i === n + 1)));
    allow();
  };
  const allow = (): void => { done.disabled = scores.size < order.length || heard.size < order.length; };
  const reference = button('Reference', () => hear(-1), { 'aria-pressed': 'false', 'aria-keyshortcuts': 'r' });
  const finish = (): void => {
    if (done.disabled) return;
    player.stop();
    given(order.map((sound, n) => ({ sound, score: scores.get(n) ?? 0 })));
  };
  const done = button('Next', finish, { class: 'main', disabled: true, 'aria-keyshortcuts': 'Enter' });
  const answers = order.map((_, n) => {
    const listen = button(`Sound ${n + 1}`, () => hear(n), { 'aria-pressed': 'false' });
    hearing.push(listen);
    return h('div', { class: 'stack' }, listen, slider({ label: `Score of sound ${n + 1}`, unit: '', min: 0, max: 100, step: 1, value: 0, upright: true,
      change: (value) => { scores.set(n, value); allow(); } }).element);
  });
  return {
    element: h('div', { class: 'panel stack' }, h('h2', {}, title),
      h('p', { class: 'quiet' }, 'How like the reference is each sound? 80 to 100 excellent, 60 good, 40 fair, 20 poor, under it bad. One of them is the reference itself: rate it 100.'),
      h('div', { class: 'row' }, reference, button('Silence', () => player.stop())), h('div', { class: 'answers' }, ...answers), h('div', { class: 'row' }, done)),
    shortcuts: [{ key: 'r', does: 'Hear the reference', run: () => hear(-1) }, ...order.map((_, n) => ({ key: 'abcd'[n] as string, does: `Hear sound ${n + 1}`, run: () => hear(n) })),
      { key: 'Enter', does: 'Next', run: finish }],
    answer, close: () => player.stop(),
  };
};
