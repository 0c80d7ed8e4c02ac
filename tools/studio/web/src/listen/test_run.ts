// A listening test from its first trial to its last answer.
import type { Answer } from './answers';
import { abxTrial } from './abx_trial';
import { endTrial, openTrial, type BlindTrial, type Kind } from './blind_trial';
import { ratingTrial, type Scores } from './rating_trial';
import type { Stage } from './stage';
import { trialBanks, wishOf, type TestPlan } from './test_plan';
import type { TrialView } from './trial_view';
import { ServerError } from '../server/request';

const kBreakEvery = 12;

type Given = 'a' | 'b' | Scores;

/** Rejects once the test is stopped, whatever was waited for. */
const untilStopped = (signal: AbortSignal) => {
  const stopped = new Promise<never>((_, reject) => { signal.addEventListener('abort', () => reject(signal.reason as Error)); });
  stopped.catch(() => undefined);
  return <T>(work: Promise<T>): Promise<T> => Promise.race([work, stopped]);
};

/** What its sounds were; null when the studio was started anew meanwhile and does not know the trial any more. */
const kindsOf = async (id: string): Promise<Record<string, Kind> | null> => {
  try {
    return await endTrial(id);
  } catch (error) {
    if (error instanceof ServerError && error.status === 404) return null;
    throw error;
  }
};

/** Its answers in the order of the trials, the practice (trial 0) first. Rejects when `signal` says so. */
export const runTest = async (plan: TestPlan, stage: Stage, signal: AbortSignal): Promise<Answer[]> => {
  const until = untilStopped(signal), banks = trialBanks(plan), answers: Answer[] = [];
  // The next trial's sounds are made while this one is heard.
  let ahead: Promise<BlindTrial | null> = Promise.resolve(null);
  const prepare = (bank: string | undefined): void => { ahead = bank === undefined ? Promise.resolve(null) : openTrial(wishOf(plan, bank)).catch(() => null); };
  const ready = async (bank: string): Promise<BlindTrial> => {
    const waiting = ahead;
    return stage.insist(async () => (await waiting) ?? openTrial(wishOf(plan, bank)), 'Getting the sounds');
  };

  const heard = async (bank: string, title: string, next: string | undefined): Promise<{ given: Given; kinds: Record<string, Kind>; seconds: number }> => {
    for (;;) {
      const trial = await until(ready(bank));
      prepare(next);
      const view: TrialView<Given> = plan.test === 'abx' ? abxTrial(trial, title) : ratingTrial(trial, title), began = performance.now();
      stage.show(view.element, view.shortcuts);
      let given: Given;
      try { given = await until(view.answer); } finally { trial.player.stop(); }
      const seconds = Math.round((performance.now() - began) / 100) / 10, kinds = await until(stage.insist(() => kindsOf(trial.id)));
      if (kinds) return { given, kinds, seconds };
      prepare(bank);
      await until(stage.pause('Once more', 'The studio was started anew and no longer knows what was what in this trial. The answers before it are kept.', 'Repeat the trial'));
    }
  };

  const one = async (n: number, bank: string, title: string, next: string | undefined): Promise<void> => {
    const { given, kinds, seconds } = await heard(bank, title, next), common = { listener: plan.listener, trial: n, bank, training: n === 0, seconds };
    if (typeof given === 'object') Object.entries(given).forEach(([place, score]) => answers.push({ test: 'rating', ...common, sound: kinds[place] as Kind, score }));
    else answers.push({ test: 'abx', ...common, a: kinds.a as Kind, b: kinds.b as Kind, x: kinds.x as Kind, answer: kinds[given] as Kind });
  };

  const practise = async (): Promise<void> => {
    await one(0, banks[banks.length - 1] as string, 'Practice', banks[0]);
    const { test, a, x, answer } = answers[0] as Answer;
    if (test === 'rating') await until(stage.pause('That was practice', 'From now on your scores count.', 'Begin the test'));
    else await until(stage.pause(x === answer ? 'Right' : 'Not right', `X was ${x === a ? 'A' : 'B'}. From now on you are not told.`, 'Begin the test'));
  };

  if (plan.practice) await practise();
  for (const [n, bank] of banks.entries()) {
    if (n > 0 && n % kBreakEvery === 0) await until(stage.pause('A break', `${n} of ${banks.length} are done. Rest your ears for a few minutes.`, 'Go on'));
    await one(n + 1, bank, `Trial ${n + 1} of ${banks.length}`, banks[n + 1]);
  }
  return answers;
};
