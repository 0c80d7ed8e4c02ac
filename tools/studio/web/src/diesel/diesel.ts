// A diesel as the server describes it.

export interface Lines { hz: number[]; db: number[] }
export interface Order { order: number; hz: number; db: number }
export interface Spectrum { rpm: number; spectrum: Lines; orders: Order[] }
export interface RecordedSpectrum extends Spectrum { recording: string; from_s: number; to_s: number }
/** What was learned at one speed and load; `recording`: the id of where, when it is at hand. */
export interface Point { rpm: number; load: number; source: string; recording: string | null }
export interface Diesel { name: string; points: Point[] }
/** What the diesel is made to do; `point`: which of the learned ones that is, -1: none. */
export interface Setting { rpm: number; load: number; point: number }

const kBeyond = 1.2, kStep_rpm = 10;

export const learnedSpan = ({ points }: Diesel): { low: number; high: number } =>
  ({ low: Math.min(...points.map(({ rpm }) => rpm)), high: Math.max(...points.map(({ rpm }) => rpm)) });

/** A little beyond what was learned, in whole steps. */
export const speedSpan = (diesel: Diesel): { min: number; max: number; step: number } => {
  const { low, high } = learnedSpan(diesel);
  return { min: Math.ceil(low / kBeyond / kStep_rpm) * kStep_rpm, max: Math.floor(high * kBeyond / kStep_rpm) * kStep_rpm, step: kStep_rpm };
};
