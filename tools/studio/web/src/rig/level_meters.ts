// Level, limiter and hammer as the engine reports them with its sound.
import type { FromEngine } from '../audio/messages';
import { h } from '../dom/element';
import { decibels, shown } from '../dom/number_text';
import { situationWords } from './situation_words';

type Levels = Extract<FromEngine, { kind: 'levels' }>;
const kFloor_db = -60, kSettle = 0.2;

const meter = (label: string, low: number, high: number): { element: HTMLElement; show(value: number, text: string): void } => {
  const bar = h('meter', { min: low, max: high, value: low, 'aria-label': label }), output = h('output', {}, '–');
  return { element: h('div', { class: 'meter' }, h('span', {}, label), bar, output),
    show: (value, text) => { bar.value = Math.max(low, Math.min(high, value)); output.textContent = text; } };
};

export const levelMeters = (): { element: HTMLElement; show(levels: Levels, boom: number): void; rest(): void } => {
  const situation = h('div', { class: 'situation' }), words = h('strong', {}, 'Silent'), rate = h('span', { class: 'quiet' });
  situation.append(words, rate);
  const level = meter('Level', kFloor_db, 0), peak = meter('Peak', kFloor_db, 0), limiter = meter('Limiter', 0, 12);
  let mean = 0;
  const rest = (): void => {
    words.textContent = 'Silent';
    rate.textContent = '';
    situation.className = 'situation';
    level.show(kFloor_db, '–');
    peak.show(kFloor_db, '–');
    limiter.show(0, '–');
  };
  return {
    element: h('div', { class: 'panel stack' }, situation, h('div', {}, level.element, peak.element, limiter.element)), rest,
    show: ({ levels, drilling }, boom) => {
      const drill = drilling[boom];
      mean += kSettle * (levels.rms - mean);
      const reduction = -20 * Math.log10(Math.max(1e-6, levels.limiterGain));
      level.show(20 * Math.log10(Math.max(1e-9, mean)), decibels(mean));
      peak.show(20 * Math.log10(Math.max(1e-9, levels.peak)), decibels(levels.peak));
      limiter.show(reduction, reduction < 0.05 ? '0 dB' : `−${shown(reduction, 0.1)} dB`);
      if (!drill) return;
      words.textContent = drill.hammering ? situationWords(drill.situation) : 'Hammer rests';
      rate.textContent = drill.hammering ? `${shown(drill.impactsHz, 0.1)} impacts a second` : '';
      situation.className = drill.hammering ? `situation is-${drill.situation}` : 'situation';
    },
  };
};
