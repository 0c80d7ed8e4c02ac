// Of many wishes only the newest counts: one is worked on, the latest waits, those between are forgotten.

export interface Newest<T> { ask(wish: T): void; end(): void }

export const newest = <T>(work: (wish: T) => Promise<void>, wrong: (error: unknown) => void): Newest<T> => {
  let waiting: { wish: T } | null = null, busy = false, ended = false;
  const run = async (): Promise<void> => {
    busy = true;
    while (waiting && !ended) {
      const { wish } = waiting;
      waiting = null;
      try {
        await work(wish);
      } catch (error) {
        if (!ended) wrong(error);
      }
    }
    busy = false;
  };
  return {
    ask: (wish) => { waiting = { wish }; if (!busy) void run(); },
    end: () => { ended = true; },
  };
};
