// A picture of lines, bars and marks over two scales, with its legend and its figures for those who do not see it.
import { h } from '../dom/element';
import { Surface, type Scale } from './surface';

export interface Series {
  name: string;
  colour: 'first' | 'second' | 'third' | 'ink';
  points: readonly (readonly [number, number])[];
  dash?: number[];
  kind?: 'line' | 'stems' | 'dots';
}
export interface PlotData {
  x: Scale; y: Scale;
  series: Series[];
  bars?: { edges: number[]; share: number[]; name: string };
}

export interface Plot { element: HTMLElement; show(data: PlotData): void; close(): void }

const range = (values: number[], room: number): [number, number] => {
  const kept = values.filter(Number.isFinite), low = Math.min(...kept), high = Math.max(...kept);
  return kept.length === 0 ? [0, 1] : [low - room * (high - low || 1), high + room * (high - low || 1)];
};

/** A scale that holds every value. */
export const scaleOf = (values: number[], unit: string, options: { log?: boolean; zero?: boolean; floor?: number } = {}): Scale => {
  const [low, high] = range(values, options.log ? 0 : 0.06);
  return { from: options.zero ? 0 : Math.max(options.floor ?? -Infinity, low), to: high > low ? high : low + 1, unit, log: options.log ?? false };
};

export const plot = (title: string, about = ''): Plot => {
  const surface = new Surface(title), legend = h('ul', { class: 'legend' });
  let data: PlotData | null = null;
  const draw = (): void => {
    if (!data) return;
    surface.start(data);
    data.bars?.share.forEach((share, n) => surface.bar(data?.bars?.edges[n] ?? 0, data?.bars?.edges[n + 1] ?? 0, 0, share, 'second', 0.75));
    for (const { points, colour, dash, kind } of data.series) {
      if (kind === 'stems') points.forEach(([x, y]) => surface.line([[x, data?.y.from ?? 0], [x, y]], colour, { width: 2 }));
      else if (kind === 'dots') points.forEach(([x, y]) => surface.dot(x, y, colour));
      else surface.line(points, colour, dash ? { dash } : {});
    }
  };
  surface.onResize = draw;
  return {
    element: h('figure', { class: 'plot panel' }, h('h3', {}, title), surface.element, legend, about ? h('figcaption', { class: 'quiet' }, about) : null),
    show: (given) => {
      data = given;
      legend.replaceChildren(...(given.bars ? [h('li', { class: 'mark-second' }, given.bars.name)] : []),
        ...given.series.map(({ name, colour }) => h('li', { class: `mark-${colour}` }, name)));
      draw();
    },
    close: () => surface.close(),
  };
};
