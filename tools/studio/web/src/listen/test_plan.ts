// What a listening test is about, as its form was filled in.
import type { Kind, TrialWish } from './blind_trial';
import { shuffled } from './shuffle';

export const kPairs = {
  ds: { words: 'Denoised and synthesised', kinds: ['denoised', 'synthesised'] },
  rs: { words: 'Recorded and synthesised', kinds: ['recorded', 'synthesised'] },
  rd: { words: 'Recorded and denoised', kinds: ['recorded', 'denoised'] },
} as const satisfies Record<string, { words: string; kinds: readonly [Kind, Kind] }>;
export type Pair = keyof typeof kPairs;

export interface TestPlan {
  test: 'abx' | 'rating';
  pair: Pair;
  trials: number;
  practice: boolean;
  listener: string;
  banks: Set<string>;
}

/** Trials that a test should have at least: 12 right of 16 are under 5 % by guessing; a 95 % interval wants six. */
export const usualTrials = (test: TestPlan['test'], banks: number): number => (test === 'abx' ? 16 : Math.max(6, banks));

/** As many banks as there are trials, every one about as often, in no order. */
export const trialBanks = ({ banks, trials }: TestPlan): string[] => {
  const made: string[] = [];
  while (made.length < trials) made.push(...shuffled([...banks]));
  return made.slice(0, trials);
};

export const wishOf = ({ test, pair }: TestPlan, bank: string): TrialWish => ({ test, bank, ...(test === 'abx' ? { pair: kPairs[pair].kinds } : {}) });
