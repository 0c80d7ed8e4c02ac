// Listen: blind tests of how like the recording the synthesis sounds.
import { noBanks } from '../bank/bank_list';
import { h } from '../dom/element';
import { button } from '../dom/fields';
import type { SoundSet } from '../server/documents';
import { askJson } from '../server/request';
import type { Page } from '../shell/page';
import { failed } from '../shell/states';
import { csvOf, type Answer } from './answers';
import { earlierTests } from './earlier_tests';
import { report } from './report';
import { setUpForm } from './set_up';
import { Stage } from './stage';
import { usualTrials, type TestPlan } from './test_plan';
import { runTest } from './test_run';

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
    const stage = new Stage(), plan: TestPlan = { test: 'abx', pair: 'ds', trials: usualTrials('abx', usable.length), practice: true, listener: '', banks: new Set(usable) };
    let running: AbortController | null = null, unsaved: string | null = null;
    const stop = button('Stop the test', () => {
      if (!confirm('Stop the test? Its answers are lost.')) return;
      running?.abort();
      setUp();
    });
    const setRunning = (now: AbortController | null): void => {
      running = now;
      unsaved = now && 'The listening test is not over; its answers are lost.';
      stop.hidden = !now;
    };

    const setUp = (): void => {
      setRunning(null);
      const form = setUpForm(plan, usable, () => void run()), earlier = h('div', {});
      stage.show(h('div', { class: 'stack' }, form.element, earlier), [{ key: 'Enter', does: 'Begin', run: () => form.begin.click() }]);
      // Without them a test can be made all the same.
      earlierTests(showResults).then((found) => { if (found) earlier.replaceChildren(found); }, () => undefined);
    };

    const another = (): void => { if (!unsaved || confirm(`${unsaved} Go on without them?`)) setUp(); };
    const showResults = (answers: readonly Answer[], kept?: HTMLElement): void =>
      stage.show(h('div', { class: 'stack' }, report(answers), kept ?? null, h('div', { class: 'row' }, button('Another test', another, { class: 'main' }))));

    const save = (answers: readonly Answer[]): void => {
      const kept = h('p', { class: 'quiet', role: 'status' }), again = button('Save again', () => send());
      const send = (): void => {
        kept.replaceChildren('Saving');
        unsaved = 'The answers of the listening test are not saved.';
        askJson<{ name: string }>('/listen/results', { method: 'POST', body: { csv: csvOf(answers) } }).then(
          ({ name }) => {
            unsaved = null;
            kept.replaceChildren(`Saved with the sound set as listening/${name}.`);
          },
          (error: Error) => kept.replaceChildren(`Not saved with the sound set (${error.message.replace(/\.$/, '')}). Download the answers, or `, again));
      };
      showResults(answers, kept);
      send();
    };

    const run = async (): Promise<void> => {
      const mine = new AbortController();
      setRunning(mine);
      try {
        const answers = await runTest({ ...plan, banks: new Set(plan.banks) }, stage, mine.signal);
        setRunning(null);
        save(answers);
      } catch (error) {
        if (!mine.signal.aborted) stage.show(failed(error, setUp));
      }
    };

    tools.replaceChildren(stop);
    place.replaceChildren(stage.element);
    setUp();
    return { shortcuts: stage.shortcuts, unsaved: () => unsaved, close: () => running?.abort() };
  },
};
