// The one audio context of the page, at the rate that is asked for, and what it takes to hear it.

let context: AudioContext | null = null;
const listeners = new Set<(context: AudioContext) => void>();

/** The context at `rate`; another rate ends the one before. */
export const outputAt = async (rate: number): Promise<AudioContext> => {
  if (context?.sampleRate !== rate) {
    const before = context, made = new AudioContext({ sampleRate: rate, latencyHint: 'interactive' });
    // At once: who asks meanwhile must get this one.
    context = made;
    made.addEventListener('statechange', () => listeners.forEach((listener) => listener(made)));
    await before?.close();
  }
  listeners.forEach((listener) => listener(context as AudioContext));
  return context as AudioContext;
};

/** Browsers keep a page silent until a person has acted on it. */
export const resume = async (): Promise<void> => { await context?.resume(); };

export const watchOutput = (listener: (context: AudioContext) => void): (() => void) => {
  listeners.add(listener);
  if (context) listener(context);
  return () => listeners.delete(listener);
};
