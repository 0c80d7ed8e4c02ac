// A bank as GET /banks/{name} gives it.

export interface Histogram { unit: string; edges: number[]; share: number[]; engine: { x: number[]; y: number[] } }
export interface Levels { recorded_db: number[]; denoised_db: number[]; synthesised_db: number[] }

export interface Refinement {
  version: string;
  controls: Record<string, number>;
  dropped: number[];
  trim_db: number;
}

export interface Bank {
  name: string; version: string;
  figures: Record<string, number | null>;
  warnings: string[];
  gaps: Histogram | null;
  amplitudes: Histogram | null;
  third_octaves: ({ centre_hz: number[] } & Levels) | null;
  modulation: ({ hz: number[] } & Levels) | null;
  clicks: { index: number; samples: number; dropped: boolean }[];
  refinement: Refinement;
}
