// One ABX trial: is X A or B?
import { h } from '../dom/element';
import { button } from '../dom/fields';
import type { BlindTrial } from './blind_trial';
import { hearing, type TrialView } from './trial_view';

export const abxTrial = (trial: BlindTrial, title: string): TrialView<'a' | 'b'> => {
  let given: (answer: 'a' | 'b') => void = () => undefined;
  const answer = new Promise<'a' | 'b'>((resolve) => { given = resolve; });
  const hear = hearing(trial, [['a', 'A', 'a'], ['b', 'B', 'b'], ['x', 'X', 'x']], () => allow());
  const say = (place: 'a' | 'b'): void => {
    if (hear.heard.size < 3) return;
    trial.player.stop();
    given(place);
  };
  const choices = ([['a', 'X is A', 'ArrowLeft', '←'], ['b', 'X is B', 'ArrowRight', '→']] as const).map(([place, words, key, shown]) =>
    button(words, () => say(place), { class: 'main', disabled: true, 'aria-label': words, 'aria-keyshortcuts': key, 'data-key': shown }));
  const allow = (): void => choices.forEach((each) => { each.disabled = hear.heard.size < 3; });
  return {
    element: h('div', { class: 'panel stack' }, h('h2', {}, title),
      h('p', { class: 'quiet' }, 'X is the same as A or the same as B. Hear all three, as often as you like: they run side by side, so that you switch in the middle of the sound.'),
      h('div', { class: 'row' }, ...hear.buttons.values(), hear.pause), h('div', { class: 'row' }, ...choices)),
    shortcuts: [...hear.shortcuts, { key: 'ArrowLeft', does: 'X is A', run: () => say('a') }, { key: 'ArrowRight', does: 'X is B', run: () => say('b') }],
    answer,
  };
};
