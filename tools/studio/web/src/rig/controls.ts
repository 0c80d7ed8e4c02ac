// The signals of the rig and the paper's six controls as fields, made from the rig's own tables.
import { h } from '../dom/element';
import { choice, pick, slider, type Field } from '../dom/fields';
import type { Change } from '../audio/engine';
import type { Control, Rig, Signal } from '../server/documents';
import { feedLever } from './lever';

export const kControlLabels: Record<string, string> = {
  mean_frequency_hz: 'Mean frequency', mean_amplitude_db: 'Mean amplitude', deviation_time: 'Deviation of time',
  deviation_amplitude: 'Deviation of amplitude', attack_factor: 'Attack', decay_factor: 'Decay',
};

export const controlSlider = (control: Control, value: number, change: (value: number) => void): Field<number> => {
  const zero = control.name === 'mean_frequency_hz';
  const step = control.unit === 'Hz' ? 0.5 : control.unit === 'dB' ? 0.5 : 0.05;
  return slider({ label: kControlLabels[control.name] ?? control.name, unit: control.unit || '×', min: zero ? 0 : control.min,
    max: control.max, step, value, ...(zero ? { words: { 0: 'its own', 0.5: 'its own' } } : {}),
    change: (given) => change(zero && given < control.min ? 0 : given) });
};

export interface RigControls {
  lever: HTMLElement;
  signals: HTMLElement;
  six: HTMLElement;
  /** Shows a value that came from elsewhere. */
  show(name: string, boom: number, value: number): void;
  showBoom(boom: number): void;
  valueOf(name: string, boom: number): number;
  /** Every value as it stands, so that an engine that starts anew has it. */
  all(): Change[];
}

export const rigControls = (rig: Rig, change: (change: Change) => void): RigControls => {
  const signal = (name: string): Signal => rig.signals.find((each) => each.name === name) as Signal;
  const values = new Map<string, Change>();
  const fields = new Map<string, Field<number>>();
  const neutral = new Map<string, number>();
  let shownBoom = 0;
  const key = (name: string, boom: number): string => `${boom} ${name}`;
  const boomOf = (name: string): number => (rig.signals.find((each) => each.name === name)?.per_boom === false ? 0 : shownBoom);
  const turn = (call: Change['call'], name: string) => (value: number): void => {
    const made = { call, name, boom: boomOf(name), value };
    values.set(key(name, made.boom), made);
    change(made);
  };
  const add = <F extends Field<number>>(call: Change['call'], name: string, start: number, make: (run: (value: number) => void) => F): F => {
    const field = make(turn(call, name));
    fields.set(name, field);
    neutral.set(name, start);
    rig.booms.forEach((_, boom) => values.set(key(name, boom), { call, name, boom: boom && boomOf(name) === 0 && !signal(name)?.per_boom && call === 'set' ? 0 : boom, value: start }));
    return field;
  };
  const plain = (name: string, label: string, step: number, start: number, words?: Record<number, string>): HTMLElement => {
    const { unit, min, max } = signal(name);
    return add('set', name, start, (run) => slider({ label, unit, min, max, step, value: start, ...(words ? { words } : {}), change: run })).element;
  };
  const normal = Math.round((rig.feed.underfeed_bar + rig.feed.overfeed_bar) / 2);
  const lever = add('set', 'feed_pressure_bar', normal, (run) => feedLever(signal('feed_pressure_bar'), rig.feed, normal, run)).element;
  const rattling = add('set', 'rattling', 0, (run) => {
    const words = signal('rattling').words ?? ['none', 'closed', 'open'];
    const field = choice('Rattling', words.map((word, n) => [String(n), word] as const), '0', (value) => run(Number(value)));
    return { element: field.element, set: (value: number) => field.set(String(value)) };
  }).element;
  const rock = rig.rocks.length < 2 ? null : add('set', 'rock', 0, (run) => {
    const field = pick('Rock', rig.rocks.map((name, n) => [String(n), name || `rock ${n}`] as const), '0', (value) => run(Number(value)));
    return { element: field.element, set: (value: number) => field.set(String(value)) };
  }).element;
  const signals = h('div', { class: 'panel stack' }, plain('engine_rpm', 'Diesel', 10, 1500, { 0: 'off' }), rattling,
    plain('rod_count', 'Rods', 1, 1), rock, plain('master_gain_db', 'Master', 0.5, 0));
  const six = h('div', { class: 'columns three' }, ...rig.controls.map((control) => add('control', control.name, control.neutral,
    (run) => controlSlider(control, control.neutral, run)).element));
  const showBoom = (boom: number): void => {
    shownBoom = boom;
    fields.forEach((field, name) => field.set(values.get(key(name, boomOf(name)))?.value ?? neutral.get(name) ?? 0));
  };
  return {
    lever, signals, six, showBoom,
    valueOf: (name, boom) => values.get(key(name, boom))?.value ?? 0,
    all: () => [...values.values()],
    show: (name, boom, value) => {
      const before = values.get(key(name, boom));
      if (!before || before.value === value) return;
      values.set(key(name, boom), { ...before, value });
      if (boom === boomOf(name)) fields.get(name)?.set(value);
    },
  };
};
