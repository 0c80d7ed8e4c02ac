// Listen: blind tests of how like the recording the synthesis sounds.
import { noBanks } from '../bank/bank_list';
import { h } from '../dom/element';
import { button, choice, number, tick } from '../dom/fields';
import type { SoundSet } from '../server/documents';
import { askJson } from '../server/request';
import type { Page } from '../shell/page';
import type { Shortcut } from '../shell/shortcuts';
import { failed, loading } from '../shell/states';
import { abxTrial, type Trial } from './abx_trial';
import { ratingTrial } from './rating_trial';
import { report } from './report';
import { csvOf, type Answer } from './results';
import { shuffled } from './shuffle';
import type { Kind } from './trial_sounds';

const kBreakEvery = 12;
const kPairs: readonly (readonly [string, string, readonly [Kind, Kind]])[] = [['ds', 'Denoised and synthesised', ['denoised', 'synthesised']],
  ['rs', 'Recorded and synthesised', ['recorded', 'synthesised']], ['rd', 'Recorded and denoised', ['recorded', 'denoised']]];

/** As many banks as there are trials, every one about as often, in no order. */
const banksOf = (banks: readonly string[], trials: number): string[] => {
  const made: string[] = [];
  while (made.length < trials) made.push(...shuffled(banks));
  return made.slice(0, trials);
};

export const listenPage: Page = {
  id: 'listen', title: 'Listen', about: 'Blind listening tests',
  open: async (place, tools) => {
    const sounds = await askJson<SoundSet>('/sound_set');
    // Without its recording a bank has nothing to be compared with.
    const usable = sounds.banks.filter(({ recording }) => recording !== null).map(({ name }) => name);
    if (usable.length === 0) {
      place.replaceChildren(sounds.banks.length ? failed(new Error('None of the banks has its recording at hand. Start the studio with --recordings and their folder.')) : noBanks());
      return { close: () => undefined };
    }
    const shortcuts: Shortcut[] = [], work = h('div', { class: 'trial stack' });
    let test: 'abx' | 'rating' = 'abx', pair = 'ds', trials = 16, training = true, answers: Answer[] = [], open: Trial<unknown> | null = null, turn = 0, running = false;
    const chosen = new Set(usable);
    const listener = h('input', { type: 'text', id: 'listener', autocomplete: 'off', maxlength: 40 });

    const end = button('Stop the test', () => {
      if (!confirm('Stop the test? Its answers are lost.')) return;
      ++turn;
      open?.close();
      setUp();
    });
    const setRunning = (on: boolean): void => { running = on; end.hidden = !on; };

    const setUp = (): void => {
      setRunning(false);
      shortcuts.splice(0, shortcuts.length, { key: 'Enter', does: 'Begin', run: () => begin.click() });
      const pairs = choice('Which two', kPairs.map(([key, words]) => [key, words] as const), pair, (value) => { pair = value; });
      const count = number('Trials', { min: 1, max: 100, step: 1 }, trials, (value) => { trials = value; });
      const begin = button('Begin', () => void run(), { class: 'main', 'aria-keyshortcuts': 'Enter' });
      const show = (): void => { pairs.element.hidden = test !== 'abx'; };
      const kind = choice('Test', [['abx', 'ABX: can they be told apart?'], ['rating', 'Rating: how like the recording?']] as const, test, (value) => {
        test = value;
        trials = value === 'abx' ? 16 : Math.max(6, usable.length);
        count.set(trials);
        show();
      });
      show();
      work.replaceChildren(h('section', { class: 'panel form', 'aria-label': 'Test' }, kind.element, pairs.element, count.element,
        h('div', { class: 'pick' }, h('label', { for: 'listener' }, 'Listener'), listener), tick('Begin with a trial for practice', training, (on) => { training = on; }).element,
        h('fieldset', { class: 'label-form plain' }, h('legend', {}, 'Banks'), ...usable.map((name) => tick(name, chosen.has(name), (on) => {
          if (on) chosen.add(name);
          else chosen.delete(name);
          begin.disabled = chosen.size === 0;
        }).element)),
        h('p', { class: 'quiet' }, 'Levels are matched by the analysis. Wear headphones and set the volume before you begin; do not touch it after.'), h('div', { class: 'row' }, begin)));
    };

    const wait = (title: string, words: string, label: string): Promise<void> => new Promise((done) => {
      const on = button(label, () => done(), { class: 'main', 'aria-keyshortcuts': 'Enter' });
      shortcuts.splice(0, shortcuts.length, { key: 'Enter', does: label, run: () => done() });
      work.replaceChildren(h('div', { class: 'panel stack' }, h('h2', {}, title), h('p', {}, words), h('div', { class: 'row' }, on)));
      on.focus();
    });

    const ask = async <T>(make: () => Promise<Trial<T>>, mine: number): Promise<T | null> => {
      work.replaceChildren(loading('Getting the sounds'));
      const trial = await make();
      if (mine !== turn) return trial.close(), null;
      open = trial;
      shortcuts.splice(0, shortcuts.length, ...trial.shortcuts);
      work.replaceChildren(trial.element);
      work.querySelector('button')?.focus();
      return trial.answer;
    };

    const oneTrial = async (bank: string, n: number, title: string, mine: number): Promise<boolean> => {
      const began = performance.now(), common = (): Pick<Answer, 'listener' | 'trial' | 'bank' | 'training' | 'seconds'> =>
        ({ listener: listener.value.trim(), trial: n, bank, training: n === 0, seconds: Math.round((performance.now() - began) / 100) / 10 });
      if (test === 'abx') {
        const kinds = kPairs.find(([key]) => key === pair)?.[2] ?? (['denoised', 'synthesised'] as const);
        const given = await ask(() => abxTrial(bank, kinds, title), mine);
        if (!given || mine !== turn) return false;
        answers.push({ test, ...common(), ...given });
        if (n === 0) await wait(given.x === given.answer ? 'Right' : 'Not right', `X was ${given.x === given.a ? 'A' : 'B'}. From now on you are not told.`, 'Begin the test');
      } else {
        const given = await ask(() => ratingTrial(bank, title), mine);
        if (!given || mine !== turn) return false;
        given.forEach(({ sound, score }) => answers.push({ test: 'rating', ...common(), sound, score }));
        if (n === 0) await wait('That was practice', 'From now on your scores count.', 'Begin the test');
      }
      return mine === turn;
    };

    const run = async (): Promise<void> => {
      const mine = ++turn, order = banksOf([...chosen], trials);
      answers = [];
      setRunning(true);
      try {
        if (training && !await oneTrial(order[order.length - 1] as string, 0, 'Practice', mine)) return;
        for (const [n, bank] of order.entries()) {
          if (n > 0 && n % kBreakEvery === 0) await wait('A break', `${n} of ${order.length} are done. Rest your ears for a few minutes.`, 'Go on');
          if (!await oneTrial(bank, n + 1, `Trial ${n + 1} of ${order.length}`, mine)) return;
        }
        setRunning(false);
        const again = button('Another test', setUp);
        const kept = h('p', { class: 'quiet', role: 'status' }, 'Saving');
        shortcuts.splice(0, shortcuts.length);
        work.replaceChildren(report(answers), kept, h('div', { class: 'row' }, again));
        await askJson<{ name: string }>('/listen/results', { method: 'POST', body: { csv: csvOf(answers) } })
          .then(({ name }) => { kept.textContent = `Saved with the sound set as listening/${name}.`; }, (error: Error) => { kept.textContent = `Not saved with the sound set: ${error.message} Download the CSV instead.`; });
      } catch (error) {
        if (mine === turn) work.replaceChildren(failed(error, setUp));
      }
    };

    tools.replaceChildren(end);
    place.replaceChildren(work);
    setUp();
    return { shortcuts, unsaved: () => (running ? 'The listening test is not over; its answers are lost.' : null), close: () => { ++turn; open?.close(); } };
  },
};
