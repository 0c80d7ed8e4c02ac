// The figures of a bank, and what its analysis warns of.
import { h } from '../dom/element';
import { shown } from '../dom/number_text';
import type { Bank } from './bank_document';

const kFigures: [string, string, string, number][] = [['clicks_found', 'impacts found', '', 1], ['rate_hz', 'rate', 'Hz', 0.1],
  ['level_db', 'level', 'dB', 0.1], ['snr_db', 'over the noise', 'dB', 0.1], ['ltas_error_db', 'spectrum against target', 'dB', 0.1],
  ['ltas_denoised_error_db', 'against denoised', 'dB', 0.1], ['modulation_error_db', 'modulation', 'dB', 0.1]];

export const bankFacts = (bank: Bank): HTMLElement => h('div', { class: 'stack' },
  h('dl', { class: 'facts' }, ...kFigures.flatMap(([key, words, unit, step]) => {
    const value = bank.figures[key];
    return value === null || value === undefined ? [] : [h('div', {}, h('dt', {}, words), h('dd', {}, `${shown(value, step)} ${unit}`.trim()))];
  })),
  ...bank.warnings.map((warning) => h('p', { class: 'note' }, warning)));
