// The banks of the sound set, one of which a page works on.
import { h } from '../dom/element';
import { shown } from '../dom/number_text';
import { situationWords } from '../rig/situation_words';
import type { SoundSet } from '../server/documents';
import { empty } from '../shell/states';

/** Where a page has no bank to work on. */
export const noBanks = (): HTMLElement => empty('The sound set has no banks yet',
  h('p', {}, 'Label parts of a recording under Annotate, then analyse them under Analyse.'));

export const bankList = (sounds: SoundSet, choose: (name: string) => void): { element: HTMLElement; show(name: string): void } => {
  const buttons = sounds.banks.map((bank) => {
    const use = sounds.uses.find((each) => each.bank === bank.name);
    const element = h('button', { type: 'button' }, bank.name, h('small', {},
      `${use ? situationWords(use.situation) : 'Unused'} · ${shown(bank.rate_hz, 0.1)} Hz${bank.refined ? ' · refined' : ''}`));
    element.addEventListener('click', () => choose(bank.name));
    return [bank.name, element] as const;
  });
  return {
    element: h('nav', { class: 'panel', 'aria-label': 'Banks' }, h('ul', { class: 'list' }, ...buttons.map(([, element]) => h('li', {}, element)))),
    show: (name) => buttons.forEach(([each, element]) => element.setAttribute('aria-current', String(each === name))),
  };
};
