// What every trial has: sounds that are switched where they are, and an answer in the end.
import { button } from '../dom/fields';
import type { Shortcut } from '../shell/shortcuts';
import type { BlindTrial } from './blind_trial';

export interface TrialView<T> { element: HTMLElement; shortcuts: Shortcut[]; answer: Promise<T> }

/** Buttons to hear the places of a trial, and to be silent; `named` are [place, name, key]. */
export const hearing = ({ player }: BlindTrial, named: readonly (readonly [string, string, string])[], changed: () => void) => {
  const heard = new Set<string>();
  const hear = (place: string): void => {
    player.choose(place);
    if (!player.playing) player.play();
    heard.add(place);
    show();
    changed();
  };
  const quiet = (): void => {
    if (player.playing) player.stop();
    else if (heard.size > 0) player.play();
    show();
  };
  const buttons = new Map(named.map(([place, name, key]) => [place, button(name, () => hear(place),
    { 'aria-label': `Hear ${name}`, 'aria-keyshortcuts': key, 'aria-pressed': 'false', 'data-key': key })] as const));
  const pause = button('Pause', quiet, { 'aria-keyshortcuts': 'Space' });
  const show = (): void => {
    buttons.forEach((each, place) => each.setAttribute('aria-pressed', String(player.playing && player.heard === place)));
    pause.textContent = player.playing || heard.size === 0 ? 'Pause' : 'Go on';
  };
  return {
    heard, buttons, pause,
    shortcuts: [...named.map(([place, name, key]) => ({ key, does: `Hear ${name}`, run: () => hear(place) })), { key: ' ', does: 'Pause, go on', run: quiet }],
  };
};
