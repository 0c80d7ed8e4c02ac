// Orders that nobody can foresee.

const below = (n: number): number => {
  const word = new Uint32Array(1), most = Math.floor(2 ** 32 / n) * n;
  do crypto.getRandomValues(word); while ((word[0] as number) >= most);
  return (word[0] as number) % n;
};

export const shuffled = <T>(values: readonly T[]): T[] => {
  const made = [...values];
  for (let i = made.length - 1; i > 0; --i) {
    const j = below(i + 1);
    [made[i], made[j]] = [made[j] as T, made[i] as T];
  }
  return made;
};
