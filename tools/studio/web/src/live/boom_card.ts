// One drill of a running daemon: what it does, which banks it draws from, its six controls.
import { h } from '../dom/element';
import type { Field } from '../dom/fields';
import { shown } from '../dom/number_text';
import { controlSlider } from '../rig/controls';
import { situationWords } from '../rig/situation_words';
import type { Control } from '../server/documents';
import type { LiveBoom } from './status';

const kColours = ['first', 'second', 'third', 'onset', 'warn', 'edge'];

export const boomCard = (name: string, controls: Control[], turn: (control: string, value: number) => void) => {
  const words = h('strong', {}), rate = h('span', { class: 'quiet' }), situation = h('div', { class: 'situation' }, words, rate);
  const shares = h('div', { class: 'shares', role: 'img' }), legend = h('ul', { class: 'legend' }), facts = h('dl', { class: 'facts' });
  let touched = 0;
  const fields = new Map<string, Field<number>>(controls.map((control) => [control.name, controlSlider(control, control.neutral, (value) => {
    touched = performance.now();
    turn(control.name, value);
  })]));
  return {
    element: h('section', { class: 'panel stack', 'aria-label': `Boom ${name}` }, h('h2', {}, name), situation, shares, legend, facts,
      h('div', { class: 'columns three' }, ...[...fields.values()].map(({ element }) => element))),
    show: (boom: LiveBoom) => {
      words.textContent = boom.hammering ? situationWords(boom.situation) : 'Hammer rests';
      situation.className = boom.hammering ? `situation is-${boom.situation}` : 'situation';
      rate.textContent = `${shown(boom.impacts_made_hz, 0.1)} impacts a second, ${shown(boom.impacts_wanted_hz, 0.1)} wanted`;
      const banks = boom.banks.filter(({ share }) => share > 0.001);
      shares.setAttribute('aria-label', `Shares of the banks: ${banks.map((bank) => `${bank.name} ${shown(100 * bank.share)} %`).join(', ') || 'none'}`);
      shares.replaceChildren(...banks.map((bank, n) => {
        const bar = h('span', {});
        bar.style.flexGrow = String(bank.share);
        bar.style.background = `var(--${kColours[n % kColours.length]})`;
        return bar;
      }));
      legend.replaceChildren(...banks.map((bank, n) => {
        const item = h('li', { class: 'mark' }, `${bank.name} ${shown(100 * bank.share)} %`);
        item.style.setProperty('--mark', `var(--${kColours[n % kColours.length]})`);
        return item;
      }));
      const levels = Object.entries(boom.levels ?? {}).map(([layer, level]) => [layer, `${shown(level.rms_db, 0.1)} dB`]);
      facts.replaceChildren(...[['feed deviation', shown(boom.feed_deviation, 0.01)], ['rods', String(boom.rods)], ['rock', String(boom.rock)], ...levels]
        .map(([key, value]) => h('div', {}, h('dt', {}, key), h('dd', {}, value))));
      // A slider in a person's hand is not pulled back by an older answer.
      if (performance.now() - touched > 600)
        fields.forEach((field, control) => { if (typeof boom[control] === 'number') field.set(boom[control] as number); });
    },
  };
};
