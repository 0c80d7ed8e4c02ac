// Length, diameter and decays of a bar as fields.
import { h } from '../dom/element';
import { slider, tick, type Field } from '../dom/fields';
import { decayOf, families, type Decay, type Family, type Mode, type Steel, type SteelRanges } from './steel';

const kDecays = { min: 0.01, max: 3, step: 0.01 };
const hertz = (hz: number): string => (hz < 1000 ? `${hz} Hz` : `${hz / 1000} kHz`);

/** `change`: what is new, and which field it is of. `modes`: those of the steel as it is. */
export const steelForm = (ranges: SteelRanges, modes: () => Mode[], change: (part: Partial<Steel>, field: string) => void) => {
  let steel: Steel;
  const { length_m, diameter_m } = ranges.bar;
  const length = slider({ label: 'Length', ...length_m, step: 0.01, change: (value) => change({ length_m: value }, 'length') });
  const diameter = slider({ label: 'Diameter', ...diameter_m, step: 0.001, change: (value) => change({ diameter_m: value }, 'diameter') });
  const decays = families.map(({ family, words, low_hz, high_hz }) => decayFields(family, words, low_hz, high_hz));

  function decayFields(family: Family, words: string, low_hz: number, high_hz: number) {
    const label = (hz: number): string => `${words}, falls by 60 dB at ${hertz(hz)} in`;
    const time = (key: 'low_s' | 'high_s', hz: number): Field<number> => slider({ label: label(hz), unit: 's', ...kDecays, value: 0.2,
      change: (value) => change({ [family]: { ...(steel[family] as Decay), [key]: value } }, `${family} ${key}`) });
    const low = time('low_s', low_hz), high = time('high_s', high_hz), both = h('div', { class: 'form inset' }, low.element, high.element);
    const own = tick(`Set the decay: ${words.toLowerCase()}`, false, (on) => change({ [family]: on ? decayOf(modes(), family, low_hz, high_hz) : null }, family));
    const name = (field: Field<number>, hz: number): void => {
      const element = field.element.querySelector('label');
      if (element) element.textContent = label(hz);
    };
    return {
      elements: [own.element, both],
      show: (decay: Decay | null) => {
        own.set(decay !== null);
        both.hidden = decay === null;
        if (!decay) return;
        low.set(decay.low_s), high.set(decay.high_s);
        name(low, decay.low_hz), name(high, decay.high_hz);
      },
    };
  }

  return {
    element: h('div', { class: 'form' }, length.element, diameter.element, ...decays.flatMap(({ elements }) => elements)),
    show: (given: Steel) => {
      steel = given;
      length.set(given.length_m);
      diameter.set(given.diameter_m);
      decays.forEach((fields, n) => fields.show(given[(families[n] as { family: Family }).family]));
    },
  };
};
