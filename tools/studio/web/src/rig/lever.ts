// The feed lever: an upright slider beside the situations its pressures lead to.
import { h } from '../dom/element';
import { slider, type Field } from '../dom/fields';
import type { Rig, Signal } from '../server/documents';

export const feedLever = (signal: Signal, feed: Rig['feed'], value: number, change: (value: number) => void): Field<number> => {
  const field = slider({ label: 'Feed', unit: signal.unit, min: signal.min, max: signal.max, step: 1, value, upright: true,
    words: { 0: 'not feeding' }, change });
  const zone = (from: number, to: number, situation: string, words: string): HTMLElement => {
    const element = h('span', { class: situation && `is-${situation}` }, to - from > 0.06 * (signal.max - signal.min) ? words : '');
    element.style.top = `${100 * (1 - to / signal.max)}%`;
    element.style.bottom = `${100 * (from / signal.max)}%`;
    return element;
  };
  const input = field.element.querySelector('input') as HTMLInputElement;
  const track = h('div', { class: 'track' });
  input.replaceWith(track);
  track.append(input, h('div', { class: 'zones', 'aria-hidden': 'true' }, zone(feed.overfeed_bar, signal.max, 'overfeed', 'overfeed'),
    zone(feed.underfeed_bar, feed.overfeed_bar, 'normal', 'normal'), zone(feed.contact_bar, feed.underfeed_bar, 'underfeed', 'underfeed'),
    zone(signal.min, feed.contact_bar, '', 'off the rock')));
  return { element: h('div', { class: 'panel lever' }, field.element), set: field.set };
};
