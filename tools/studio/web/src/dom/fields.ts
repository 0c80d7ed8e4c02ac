// Fields a person turns: every one has a name that is read out, a value that is shown, and keys that move it.
import { h } from './element';
import { shown } from './number_text';

export interface Field<T> {
  readonly element: HTMLElement;
  set(value: T): void;
}

export interface Span { min: number; max: number; step: number }

let count = 0;
const fresh = (): string => `field-${++count}`;

export interface SliderOptions extends Span {
  label: string;
  unit: string;
  value: number;
  /** What a value is called instead of its number, such as 0: "off". */
  words?: Record<number, string>;
  upright?: boolean;
  change(value: number): void;
}

export const slider = (options: SliderOptions): Field<number> => {
  const id = fresh();
  const text = (value: number): string =>
    options.words?.[value] ?? `${shown(value, options.step)}${options.unit ? ` ${options.unit}` : ''}`;
  const output = h('output', { for: id }, text(options.value));
  const input = h('input', { type: 'range', id, min: options.min, max: options.max, step: options.step,
    'aria-valuetext': text(options.value), ...(options.upright ? { 'aria-orientation': 'vertical' } : {}) });
  const set = (value: number): void => {
    input.value = String(value);
    output.textContent = text(value);
    input.setAttribute('aria-valuetext', text(value));
  };
  set(options.value);
  input.addEventListener('input', () => {
    set(Number(input.value));
    options.change(Number(input.value));
  });
  return { element: h('div', { class: options.upright ? 'slider upright' : 'slider' },
    h('label', { for: id }, options.label), output, input), set };
};

export const choice = <T extends string>(
  label: string, entries: readonly (readonly [T, string])[], value: T, change: (value: T) => void,
): Field<T> => {
  const name = fresh();
  const inputs = entries.map(([key]) => h('input', { type: 'radio', name, value: key, id: `${name}-${key}` }));
  inputs.forEach((input) => input.addEventListener('change', () => change(input.value as T)));
  const set = (wanted: T): void => inputs.forEach((input) => { input.checked = input.value === wanted; });
  set(value);
  return { element: h('fieldset', { class: 'choice' }, h('legend', {}, label),
    h('div', {}, ...entries.flatMap(([key, words], i) => [inputs[i], h('label', { for: `${name}-${key}` }, words)]))), set };
};

export const pick = (
  label: string, entries: readonly (readonly [string, string])[], value: string, change: (value: string) => void,
): Field<string> => {
  const id = fresh();
  const select = h('select', { id }, ...entries.map(([key, words]) => h('option', { value: key }, words)));
  select.value = value;
  select.addEventListener('change', () => change(select.value));
  return { element: h('div', { class: 'pick' }, h('label', { for: id }, label), select),
    set: (wanted) => { select.value = wanted; } };
};

export const number = (
  label: string, span: Span, value: number, change: (value: number) => void,
): Field<number> => {
  const id = fresh();
  const input = h('input', { type: 'number', id, min: span.min, max: span.max, step: span.step, value: String(value) });
  input.addEventListener('change', () => {
    const given = Number(input.value);
    if (input.value !== '' && given >= span.min && given <= span.max) change(given);
    else input.reportValidity();
  });
  return { element: h('div', { class: 'pick' }, h('label', { for: id }, label), input),
    set: (wanted) => { input.value = String(wanted); } };
};

export const tick = (label: string, value: boolean, change: (value: boolean) => void): Field<boolean> => {
  const id = fresh();
  const input = h('input', { type: 'checkbox', id });
  input.checked = value;
  input.addEventListener('change', () => change(input.checked));
  return { element: h('div', { class: 'tick' }, input, h('label', { for: id }, label)), set: (wanted) => { input.checked = wanted; } };
};

export const button = (
  words: string, run: () => void, properties: Record<string, unknown> = {},
): HTMLButtonElement => {
  const element = h('button', { type: 'button', ...properties }, words);
  element.addEventListener('click', run);
  return element;
};
