// Statistics of a listening test: exact binomial test, median and its distribution-free interval.

/** ln C(n, k) */
const lnChoose = (n: number, k: number): number => {
  let sum = 0;
  for (let i = 1; i <= k; ++i) sum += Math.log((n - k + i) / i);
  return sum;
};

/** Probability of at most k right answers of n by guessing. */
const atMost = (k: number, n: number): number => {
  let sum = 0;
  for (let i = 0; i <= k; ++i) sum += Math.exp(lnChoose(n, i) - n * Math.LN2);
  return Math.min(1, sum);
};

/** Probability of at least k right answers of n by guessing: the one-sided p-value of an ABX test. */
export const guessing = (k: number, n: number): number => {
  if (k <= 0) return 1;
  let sum = 0;
  for (let i = n; i >= k; --i) sum += Math.exp(lnChoose(n, i) - n * Math.LN2);
  return Math.min(1, sum);
};

/** Least number of right answers of n that guessing reaches with under 5 %; null where none does. */
export const leastShown = (n: number): number | null => {
  for (let k = 0; k <= n; ++k) if (guessing(k, n) < 0.05) return k;
  return null;
};

export const median = (values: readonly number[]): number => {
  const sorted = [...values].sort((a, b) => a - b), middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] as number : ((sorted[middle - 1] as number) + (sorted[middle] as number)) / 2;
};

/** Order statistics between which the median of the population lies with at least 95 %; null under six values. */
export const medianInterval = (values: readonly number[]): [number, number] | null => {
  const n = values.length, sorted = [...values].sort((a, b) => a - b);
  let below = -1;
  while (atMost(below + 1, n) <= 0.025) ++below;
  return below < 0 ? null : [sorted[below] as number, sorted[n - 1 - below] as number];
};
