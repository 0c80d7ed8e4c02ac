// The form of a listening test.
import { h } from '../dom/element';
import { button, choice, number, tick } from '../dom/fields';
import { kPairs, usualTrials, type Pair, type TestPlan } from './test_plan';

/** Fills in `plan`, which keeps what was chosen for the next test. */
export const setUpForm = (plan: TestPlan, banks: readonly string[], run: () => void) => {
  const begin = button('Begin', run, { class: 'main', 'aria-keyshortcuts': 'Enter' });
  const listener = h('input', { type: 'text', id: 'listener', autocomplete: 'off', maxlength: 40, on: { input: () => { plan.listener = listener.value.trim(); } } });
  listener.value = plan.listener;
  const pairs = choice('Which two', (Object.keys(kPairs) as Pair[]).map((key) => [key, kPairs[key].words] as const), plan.pair, (pair) => { plan.pair = pair; });
  const count = number('Trials', { min: 1, max: 100, step: 1 }, plan.trials, (trials) => { plan.trials = trials; });
  const kind = choice('Test', [['abx', 'ABX: can they be told apart?'], ['rating', 'Rating: how like the recording?']] as const, plan.test, (test) => {
    plan.test = test;
    count.set(plan.trials = usualTrials(test, plan.banks.size));
    pairs.element.hidden = test !== 'abx';
  });
  pairs.element.hidden = plan.test !== 'abx';
  const choose = (name: string, on: boolean): void => {
    if (on) plan.banks.add(name);
    else plan.banks.delete(name);
    begin.disabled = plan.banks.size === 0;
  };
  return {
    begin,
    element: h('section', { class: 'panel form', 'aria-label': 'Test' }, kind.element, pairs.element,
      h('div', { class: 'label-form' }, count.element, h('div', { class: 'pick' }, h('label', { for: 'listener' }, 'Listener'), listener)),
      tick('Begin with a trial for practice', plan.practice, (on) => { plan.practice = on; }).element,
      h('fieldset', { class: 'label-form plain names' }, h('legend', {}, 'Banks'), ...banks.map((name) => tick(name, plan.banks.has(name), (on) => choose(name, on)).element)),
      h('p', { class: 'quiet' }, 'The sounds of a trial are equally loud (ISO 532-1). Put on headphones and set the volume before you begin; leave it as it is until the end.'),
      h('div', { class: 'row' }, begin)),
  };
};
