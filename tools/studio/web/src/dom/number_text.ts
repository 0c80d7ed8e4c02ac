// Numbers as a person reads them: a true minus, as many decimals as the step has, times as minutes.

export const decimalsOf = (step: number): number => Math.min(6, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));

export const shown = (value: number, step = 1): string =>
  value.toFixed(decimalsOf(step)).replace(/^-(?=.*[1-9])/, '−').replace(/^-/, '');

export const decibels = (amplitude: number): string =>
  amplitude > 1e-5 ? `${shown(20 * Math.log10(amplitude), 0.1)} dB` : '−∞ dB';

export const clock = (seconds: number, decimals = 0): string => {
  const unit = 10 ** decimals, all = Math.round(seconds * unit), minutes = Math.floor(all / (60 * unit)), hours = Math.floor(minutes / 60);
  const rest = ((all - 60 * unit * minutes) / unit).toFixed(decimals).padStart(decimals ? 3 + decimals : 2, '0');
  return hours ? `${hours}:${String(minutes % 60).padStart(2, '0')}:${rest}` : `${minutes}:${rest}`;
};
