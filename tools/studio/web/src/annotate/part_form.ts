// What a label says of a part: situation, rods, rock, speed, pressures.
import { h } from '../dom/element';
import { pick } from '../dom/fields';
import { situations, situationWords } from '../rig/situation_words';
import type { Part } from './part';

type NumberKey = 'from_s' | 'to_s' | 'rods' | 'rpm' | 'feed' | 'percussion';
const kNumbers: { key: NumberKey; label: string; min: number; max: number; step: number }[] = [
  { key: 'from_s', label: 'From, s', min: 0, max: 1e6, step: 0.001 }, { key: 'to_s', label: 'To, s', min: 0, max: 1e6, step: 0.001 },
  { key: 'rods', label: 'Rods', min: 1, max: 20, step: 1 }, { key: 'rpm', label: 'Diesel, r/min', min: 1, max: 4000, step: 1 },
  { key: 'feed', label: 'Feed, bar', min: 1, max: 300, step: 0.1 }, { key: 'percussion', label: 'Percussion, bar', min: 1, max: 300, step: 0.1 }];

export const partForm = (rocks: string[], length_s: number, change: (part: Part) => void) => {
  let part: Part | null = null;
  const turn = (given: Partial<Part>): void => { if (part) change({ ...part, ...given }); };
  const situation = pick('Situation', situations.map((name) => [name, situationWords(name)] as const), 'normal', (value) => turn({ situation: value }));
  const rock = h('input', { type: 'text', id: 'part-rock', list: 'part-rocks', autocomplete: 'off', pattern: '[A-Za-z0-9_.\\-]*' });
  rock.addEventListener('change', () => { if (rock.reportValidity()) turn({ rock: rock.value || null }); });
  const numbers = kNumbers.map(({ key, label, min, max, step }) => {
    const time = key === 'from_s' || key === 'to_s', id = `part-${key}`;
    const input = h('input', { type: 'number', id, min, max: time ? length_s : max, step: time ? 'any' : step, ...(time ? {} : { placeholder: 'not said' }) });
    input.addEventListener('change', () => {
      if (!part || !input.reportValidity() || (time && input.value === '')) return;
      const value = input.value === '' ? null : Number(input.value);
      if (key === 'from_s' && (value ?? 0) >= part.to_s) return show(part);
      if (key === 'to_s' && (value ?? 0) <= part.from_s) return show(part);
      turn({ [key]: value });
    });
    return { key, input, element: h('div', { class: 'pick' }, h('label', { for: id }, label), input) };
  });
  const element = h('fieldset', { class: 'label-form plain' }, h('legend', { class: 'unseen' }, 'Selected part'), ...numbers.slice(0, 2).map((each) => each.element), situation.element,
    numbers[2]?.element, h('div', { class: 'pick' }, h('label', { for: 'part-rock' }, 'Rock'), rock, h('datalist', { id: 'part-rocks' }, ...rocks.map((name) => h('option', { value: name })))),
    ...numbers.slice(3).map((each) => each.element));
  const show = (given: Part | null): void => {
    part = given;
    element.disabled = given === null;
    situation.set(given?.situation ?? 'normal');
    rock.value = given?.rock ?? '';
    numbers.forEach(({ key, input }) => {
      const value = given?.[key] ?? null;
      input.value = value === null ? '' : String(key === 'from_s' || key === 'to_s' ? Math.round(value * 1e4) / 1e4 : value);
    });
  };
  show(null);
  return { element, show };
};
