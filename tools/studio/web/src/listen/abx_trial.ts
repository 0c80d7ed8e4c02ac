// One ABX trial: is X A or B?
import { h } from '../dom/element';
import { button } from '../dom/fields';
import type { Shortcut } from '../shell/shortcuts';
import { oneOf } from './shuffle';
import { trialPlayer, type Kind } from './trial_sounds';

export interface AbxAnswer { a: Kind; b: Kind; x: Kind; answer: Kind }
export interface Trial<T> { element: HTMLElement; shortcuts: Shortcut[]; answer: Promise<T>; close(): void }

export const abxTrial = async (bank: string, pair: readonly [Kind, Kind], title: string): Promise<Trial<AbxAnswer>> => {
  const player = await trialPlayer(bank, pair);
  const [a, b] = oneOf([pair, [pair[1], pair[0]] as const]), x = oneOf(pair);
  let given: (answer: AbxAnswer) => void = () => undefined;
  const answer = new Promise<AbxAnswer>((resolve) => { given = resolve; });
  const letters = { A: a, B: b, X: x };
  type Letter = keyof typeof letters;
  const buttons = (Object.keys(letters) as Letter[]).map((letter) => button(letter, () => hear(letter), { 'aria-label': `Hear ${letter}`, 'aria-keyshortcuts': letter.toLowerCase(), 'aria-pressed': 'false' }));
  const heard = new Set<Letter>();
  const hear = (letter: Letter): void => {
    player.choose(letters[letter]);
    if (!player.playing) player.play();
    heard.add(letter);
    buttons.forEach((each) => each.setAttribute('aria-pressed', String(each.textContent === letter)));
    choices.forEach((each) => { each.disabled = heard.size < 3; });
  };
  const say = (kind: Kind): void => {
    if (heard.size < 3) return;
    player.stop();
    given({ a, b, x, answer: kind });
  };
  const choices = [button('X is A', () => say(a), { class: 'main', disabled: true, 'aria-keyshortcuts': 'ArrowLeft' }), button('X is B', () => say(b), { class: 'main', disabled: true, 'aria-keyshortcuts': 'ArrowRight' })];
  return {
    element: h('div', { class: 'panel stack' }, h('h2', {}, title), h('p', { class: 'quiet' }, 'Hear all three, as often as you like; they go on side by side.'),
      h('div', { class: 'row' }, ...buttons, button('Silence', () => player.stop())), h('div', { class: 'row' }, ...choices)),
    shortcuts: [...(Object.keys(letters) as Letter[]).map((letter) => ({ key: letter.toLowerCase(), does: `Hear ${letter}`, run: () => hear(letter) })),
      { key: 'ArrowLeft', does: 'X is A', run: () => say(a) }, { key: 'ArrowRight', does: 'X is B', run: () => say(b) }],
    answer, close: () => player.stop(),
  };
};
