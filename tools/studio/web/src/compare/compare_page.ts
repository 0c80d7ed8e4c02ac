// Compare: recorded, denoised and synthesised, switched where they are, and how they differ.
import { bankFacts } from '../bank/bank_facts';
import { bankList, noBanks } from '../bank/bank_list';
import { bankPlots } from '../bank/bank_plots';
import type { Bank } from '../bank/bank_document';
import { fileContext, loadSound } from '../audio/sound_files';
import { SwitchingPlayer } from '../audio/switching_player';
import { h } from '../dom/element';
import { choice } from '../dom/fields';
import type { SoundSet } from '../server/documents';
import { askJson, ServerError } from '../server/request';
import type { Page } from '../shell/page';
import type { Shortcut } from '../shell/shortcuts';
import { failed, loading } from '../shell/states';
import { transport } from './transport';

const kSounds = ['recorded', 'denoised', 'synthesised'] as const;
const kKeys = { recorded: 'r', denoised: 'd', synthesised: 's' };

/** Those of the three that are to be had: recorded and denoised want the recording. */
const loadSounds = async (name: string): Promise<[string, AudioBuffer][]> => {
  const sounds = await Promise.all(kSounds.map(async (kind): Promise<[string, AudioBuffer] | null> => {
    try {
      return [kind, await loadSound(`/banks/${name}/sound/${kind}`)];
    } catch (error) {
      if (error instanceof ServerError && error.status === 404) return null;
      throw error;
    }
  }));
  return sounds.filter((sound): sound is [string, AudioBuffer] => sound !== null);
};

export const comparePage: Page = {
  id: 'compare', title: 'Compare', about: 'Recorded, denoised, synthesised at the same place',
  open: async (place) => {
    const sounds = await askJson<SoundSet>('/sound_set');
    const first = sounds.banks[0];
    if (!first) {
      place.replaceChildren(noBanks());
      return { close: () => undefined };
    }
    const context = await fileContext();
    const work = h('div', { class: 'stack' });
    const shortcuts: Shortcut[] = [];
    let ending: (() => void)[] = [], turn = 0;
    const end = (): void => { ending.forEach((each) => each()); ending = []; };
    const show = async (name: string): Promise<void> => {
      const mine = ++turn;
      end();
      list.show(name);
      work.replaceChildren(loading('Reading the bank; the first time its analysis is repeated'));
      try {
        const [bank, loaded] = await Promise.all([askJson<Bank>(`/banks/${name}`), loadSounds(name)]);
        if (mine !== turn) return;
        const player = new SwitchingPlayer(context), buffers = new Map(loaded);
        loaded.forEach(([kind, buffer]) => player.put(kind, buffer));
        player.loop = { from_s: 0, to_s: player.length_s };
        const bar = transport(player, () => buffers.get(player.heard));
        const choose = (kind: string): void => {
          if (!buffers.has(kind)) return;
          player.choose(kind);
          field.set(kind);
          bar.redraw();
        };
        const field = choice('Heard', loaded.map(([kind]) => [kind, kind] as const), player.heard, choose);
        const plots = bankPlots();
        work.replaceChildren(h('div', { class: 'panel stack' }, h('div', { class: 'row' }, h('h2', { class: 'grow' }, name), field.element), bar.element),
          bankFacts(bank), plots.element);
        plots.show(bank);
        shortcuts.splice(0, shortcuts.length, ...bar.shortcuts, ...kSounds.map((kind) => ({ key: kKeys[kind], does: `Hear ${kind}`, run: () => choose(kind) })));
        ending = [bar.close, plots.close];
      } catch (error) {
        if (mine === turn) work.replaceChildren(failed(error, () => void show(name)));
      }
    };
    const list = bankList(sounds, (name) => void show(name));
    place.replaceChildren(h('div', { class: 'columns with-list' }, list.element, work));
    void show(first.name);
    return { shortcuts, close: end };
  },
};
