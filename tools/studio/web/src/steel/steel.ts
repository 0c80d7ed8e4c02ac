// A steel as the server takes it, and what it says of one.

export type Family = 'transversal' | 'longitudinal';
export interface Decay { low_hz: number; low_s: number; high_hz: number; high_s: number }
export type Steel = { readonly length_m: number; readonly diameter_m: number } & { readonly [F in Family]: Decay | null };

export interface Mode { family: Family; mode: number; target_hz: number; model_hz: number; error_cents: number; t60_s: number }
export interface Span { value: number; min: number; max: number; unit: string }
/** GET /steel */
export interface SteelRanges { bar: { length_m: Span; diameter_m: Span } }
/** GET /tools/{name}, of a bar; what else its file holds does not matter here. */
export interface StoredTool {
  name: string; version: string;
  tool: { length_m: number; diameter_m: number; voicing?: { equaliser?: unknown[] } } & { [F in Family]?: { t60?: Decay } };
}

/** What a family is called, and the two frequencies at which its decay is set: a bar's modes lie around them. */
export const families: { family: Family; words: string; low_hz: number; high_hz: number }[] = [
  { family: 'transversal', words: 'Bending', low_hz: 500, high_hz: 8000 },
  { family: 'longitudinal', words: 'Lengthwise', low_hz: 5000, high_hz: 15000 }];

const wished = (decay: Decay | undefined): Decay | null => (decay && decay.low_s > 0 ? decay : null);
export const steelOf = ({ tool }: StoredTool): Steel => ({ length_m: tool.length_m, diameter_m: tool.diameter_m,
  transversal: wished(tool.transversal?.t60), longitudinal: wished(tool.longitudinal?.t60) });

/** Whether its sound was fitted to a recording, which length, diameter and decay do not hold. */
export const isFitted = ({ tool }: StoredTool): boolean => (tool.voicing?.equaliser?.length ?? 0) > 0;

/** As `rigsound tool` names one. */
export const nameOf = ({ length_m, diameter_m }: Steel): string => `steel_${Math.round(1000 * length_m)}x${Math.round(1000 * diameter_m)}`;

/** The decay that a family has without a wish, read off its modes. */
export const decayOf = (modes: Mode[], family: Family, low_hz: number, high_hz: number): Decay => {
  const at = (hz: number): number => {
    const own = modes.filter((mode) => mode.family === family).sort((a, b) => Math.abs(Math.log(a.model_hz / hz)) - Math.abs(Math.log(b.model_hz / hz)));
    return Math.max(0.01, Math.round(100 * (own[0]?.t60_s ?? 0.2)) / 100);
  };
  return { low_hz, low_s: at(low_hz), high_hz, high_s: at(high_hz) };
};
