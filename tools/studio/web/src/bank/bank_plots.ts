// What report.html shows of a bank: spectra, modulation, gaps and amplitudes, recorded against synthesised.
import { plot, scaleOf, type Series } from '../chart/plot';
import { h } from '../dom/element';
import { choice } from '../dom/fields';
import type { Bank, Histogram, Levels } from './bank_document';

type Shown = 'levels' | 'differences';

/** What denoised and synthesised have more than the recording. */
const differences = (x: number[], { recorded_db, denoised_db, synthesised_db }: Levels): Series[] =>
  ([['denoised', 'first', denoised_db], ['synthesised', 'third', synthesised_db]] as const).map(([name, colour, y]) =>
    ({ name: `${name} over recorded`, colour, points: x.map((v, n) => [v, (y[n] ?? 0) - (recorded_db[n] ?? 0)] as const) }));

const three = (x: number[], levels: Levels): Series[] => {
  const line = (name: string, colour: Series['colour'], y: number[], dash?: number[]): Series =>
    ({ name, colour, points: x.map((v, n) => [v, y[n] ?? 0] as const), ...(dash ? { dash } : {}) });
  return [line('recorded', 'second', levels.recorded_db), line('denoised', 'first', levels.denoised_db),
    line('synthesised', 'third', levels.synthesised_db, [6, 3])];
};

export const bankPlots = () => {
  const thirds = plot('Third-octave levels'), modulation = plot('Modulation spectrum'), gaps = plot('Gaps between impacts'),
    amplitudes = plot('Amplitudes of impacts');
  const spectrum = (picture: typeof thirds, x: number[], levels: Levels | null, low: number): void => {
    if (!levels) return;
    const series = (shown === 'levels' ? three : differences)(x, levels).map((each) => ({ ...each, points: each.points.filter(([at]) => at >= low) }));
    picture.show({ x: { ...scaleOf(x.filter((at) => at >= low), 'Hz', { log: true }) }, y: scaleOf(series.flatMap(({ points }) => points.map(([, y]) => y)), 'dB'), series });
  };
  const histogram = (picture: typeof gaps, data: Histogram): void => {
    const series: Series[] = [{ name: 'engine', colour: 'first', points: data.engine.x.map((x, n) => [x, data.engine.y[n] ?? 0] as const) }];
    picture.show({ x: scaleOf(data.edges, data.unit), y: scaleOf([...data.share, ...data.engine.y], '', { zero: true }), series,
      bars: { edges: data.edges, share: data.share, name: 'recorded' } });
  };
  const all = [thirds, modulation, gaps, amplitudes];
  let shown: Shown = 'levels', bank: Bank | null = null;
  const what = choice('Spectra', [['levels', 'Levels'], ['differences', 'Differences to the recording']] as const, shown, (value) => { shown = value; draw(); });
  const element = h('div', { class: 'stack' }, what.element, h('div', { class: 'columns two' }, ...all.map((each) => each.element)));
  const draw = (): void => {
    if (!bank) return;
    element.hidden = !bank.third_octaves || !bank.modulation || !bank.gaps || !bank.amplitudes;
    if (!bank.third_octaves || !bank.modulation || !bank.gaps || !bank.amplitudes) return;
    spectrum(thirds, bank.third_octaves.centre_hz, bank.third_octaves, 20);
    spectrum(modulation, bank.modulation.hz, bank.modulation, 0.5);
    histogram(gaps, bank.gaps);
    histogram(amplitudes, bank.amplitudes);
  };
  return {
    element, show: (given: Bank) => { bank = given; draw(); },
    close: () => all.forEach((each) => each.close()),
  };
};
