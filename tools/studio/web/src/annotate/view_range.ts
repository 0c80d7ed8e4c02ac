// The stretch of a recording that is on the screen.

export interface ViewRange { from_s: number; to_s: number }
const kLeast_s = 0.02;

/** Moved inside a recording of `length_s` without a change of its own length, where that fits. */
export const inside = ({ from_s, to_s }: ViewRange, length_s: number): ViewRange => {
  const span = Math.min(length_s, to_s - from_s), from = Math.max(0, Math.min(length_s - span, from_s));
  return { from_s: from, to_s: from + span };
};

/** `at_s` stays where it is on the screen. */
export const zoomed = (range: ViewRange, factor: number, at_s: number, length_s: number): ViewRange => {
  const span = Math.max(Math.min(kLeast_s, length_s), Math.min(length_s, (range.to_s - range.from_s) * factor));
  const share = (at_s - range.from_s) / (range.to_s - range.from_s), from = at_s - share * span;
  return inside({ from_s: from, to_s: from + span }, length_s);
};

export const moved = (range: ViewRange, by_s: number, length_s: number): ViewRange =>
  inside({ from_s: range.from_s + by_s, to_s: range.to_s + by_s }, length_s);

/** So that `at_s` is seen. */
export const showing = (range: ViewRange, at_s: number, length_s: number): ViewRange => {
  const span = range.to_s - range.from_s;
  if (at_s < range.from_s) return inside({ from_s: at_s - 0.1 * span, to_s: at_s + 0.9 * span }, length_s);
  if (at_s > range.to_s) return inside({ from_s: at_s - 0.1 * span, to_s: at_s + 0.9 * span }, length_s);
  return range;
};
