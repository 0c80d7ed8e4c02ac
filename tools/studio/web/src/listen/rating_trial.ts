// One trial of ratings after ITU-R BS.1534: an open reference, and hidden among the rated sounds the reference again and its
// 3.5 kHz anchor.
import { h } from '../dom/element';
import { button, slider } from '../dom/fields';
import type { BlindTrial } from './blind_trial';
import { hearing, type TrialView } from './trial_view';

/** The scale of BS.1534, from its top; each word covers 20 points. */
const kScale = ['excellent', 'good', 'fair', 'poor', 'bad'];
const kWords = Object.fromEntries(Array.from({ length: 101 }, (_, score) => [score, `${score} ${kScale[4 - Math.min(4, Math.floor(score / 20))]}`]));
const kLetters = 'abcdefgh';

/** Scores, by place. */
export type Scores = Record<string, number>;

export const ratingTrial = (trial: BlindTrial, title: string): TrialView<Scores> => {
  const rated = trial.places.filter((place) => place !== 'reference'), scores: Scores = {}, fields = new Map<string, HTMLElement>();
  let given: (scores: Scores) => void = () => undefined;
  const answer = new Promise<Scores>((resolve) => { given = resolve; });
  const hear = hearing(trial, [['reference', 'Reference', 'r'], ...rated.map((place, n) => [place, `Sound ${place}`, kLetters[n] ?? ''] as const)], () => {
    // The arrows then move the score of what is heard.
    fields.get(trial.player.heard)?.querySelector('input')?.focus();
    allow();
  });
  const finish = (): void => {
    if (done.disabled) return;
    trial.player.stop();
    given(scores);
  };
  const done = button('Next', finish, { class: 'main', disabled: true, 'aria-keyshortcuts': 'Enter' });
  const left = h('span', { class: 'quiet', role: 'status' });
  const allow = (): void => {
    const unheard = rated.filter((place) => !hear.heard.has(place)).length, unrated = rated.filter((place) => scores[place] === undefined).length;
    done.disabled = unheard + unrated > 0;
    left.textContent = done.disabled ? `${unheard} to hear, ${unrated} to rate` : '';
  };
  for (const place of rated) fields.set(place, slider({ label: `Score of sound ${place}`, unit: '', min: 0, max: 100, step: 1, value: 0, upright: true, words: kWords,
    change: (value) => { scores[place] = value; allow(); } }).element);
  allow();
  return {
    element: h('div', { class: 'panel stack' }, h('h2', {}, title),
      h('p', { class: 'quiet' }, 'How like the reference is each sound? One of them is the reference itself: rate that one 100.'),
      h('div', { class: 'row' }, hear.buttons.get('reference'), hear.pause),
      h('div', { class: 'answers' }, h('div', { class: 'scale', 'aria-hidden': 'true' }, ...kScale.map((word) => h('span', {}, word))),
        ...rated.map((place) => h('div', { class: 'answer' }, hear.buttons.get(place), fields.get(place)))),
      h('div', { class: 'row' }, done, left)),
    shortcuts: [...hear.shortcuts, { key: 'Enter', does: 'Next', run: finish }],
    answer,
  };
};
