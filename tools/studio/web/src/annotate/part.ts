// Labelled parts of a recording, as the label track has them.

export interface Part {
  from_s: number; to_s: number; situation: string;
  rods: number | null; rock: string | null; rpm: number | null; feed: number | null; percussion: number | null;
}

export interface Suggestion { from_s: number; to_s: number; kinds: string[]; rhythmic: number; rate_hz: number | null; level_db: number; confidence: number }

export const kLeast_s = 0.05;

export const emptyPart = (from_s: number, to_s: number): Part =>
  ({ from_s, to_s, situation: 'normal', rods: null, rock: null, rpm: null, feed: null, percussion: null });

export const inOrder = (parts: readonly Part[]): Part[] => [...parts].sort((a, b) => a.from_s - b.from_s || a.to_s - b.to_s);

export const partWords = (part: Part): string => [part.situation.replace('_', ' '), part.rods && `${part.rods} ${part.rods === 1 ? 'rod' : 'rods'}`, part.rock].filter(Boolean).join(' · ');
