// A canvas that keeps the size of its box and the colours of the theme, with scales on two sides.
import { clock, decimalsOf, shown } from '../dom/number_text';
import { reduced } from './reduced_line';

export interface Margins { left: number; right: number; top: number; bottom: number }
/** `time`: seconds, written as a clock does where they are minutes. */
export interface Scale { from: number; to: number; log?: boolean; unit: string; words?: string[]; time?: boolean }
export interface Scales { x: Scale; y: Scale }

const kClockFrom_s = 120, kClockSteps_s = [10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600];

/** Round numbers between two values, about `count` of them. */
export const ticksOf = (scale: Scale, count: number): number[] => {
  const { from, to } = scale;
  if (scale.log) {
    const all: number[] = [];
    for (let decade = 10 ** Math.floor(Math.log10(from)); decade <= to; decade *= 10)
      for (const step of [1, 2, 5]) if (decade * step >= from * 0.999 && decade * step <= to * 1.001) all.push(decade * step);
    return all.length > count + 2 ? all.filter((value) => /^[1]0*(\.0*)?$|^0\.0*1$/.test(String(value))) : all;
  }
  const rough = (to - from) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(rough));
  const steps = scale.time && to - from >= kClockFrom_s ? kClockSteps_s : [1, 2, 5, 10].map((factor) => factor * power);
  const step = steps.find((value) => value >= rough) ?? rough;
  const all: number[] = [];
  for (let n = Math.ceil(from / step - 1e-9); n * step <= to + step * 1e-6; ++n) all.push(n * step);
  return all;
};

export const tickText = (value: number): string =>
  Math.abs(value) >= 1000 ? `${+(value / 1000).toPrecision(3)}k` : `${+value.toPrecision(4)}`.replace('-', '−');

/** A tick of a time, with as many decimals as the ticks are apart. */
const timeText = (value: number, { to }: Scale, apart: number): string =>
  to >= kClockFrom_s ? clock(value, decimalsOf(apart)) : shown(value, apart);

export class Surface {
  readonly element = document.createElement('div');
  readonly canvas = document.createElement('canvas');
  readonly paint: CanvasRenderingContext2D;
  inner = { x: 0, y: 0, width: 1, height: 1 };
  private size = { width: 0, height: 0 };
  private scales: Scales = { x: { from: 0, to: 1, unit: '' }, y: { from: 0, to: 1, unit: '' } };
  private readonly observer: ResizeObserver;
  onResize: () => void = () => undefined;

  constructor(name: string, private readonly margins: Margins = { left: 48, right: 12, top: 8, bottom: 26 }) {
    this.element.className = 'surface';
    this.element.append(this.canvas);
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', name);
    this.paint = this.canvas.getContext('2d') as CanvasRenderingContext2D;
    this.observer = new ResizeObserver(() => { this.fit(); this.onResize(); });
    this.observer.observe(this.element);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.onResize());
  }

  colour(name: string): string { return getComputedStyle(this.element).getPropertyValue(`--${name}`).trim() || name; }

  private fit(): void {
    const box = this.element.getBoundingClientRect(), ratio = devicePixelRatio;
    this.size = { width: box.width, height: box.height };
    this.canvas.width = Math.max(1, Math.round(box.width * ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * ratio));
    this.paint.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { left, right, top, bottom } = this.margins;
    this.inner = { x: left, y: top, width: Math.max(1, box.width - left - right), height: Math.max(1, box.height - top - bottom) };
  }

  private place(scale: Scale, value: number): number {
    return scale.log ? Math.log(value / scale.from) / Math.log(scale.to / scale.from) : (value - scale.from) / (scale.to - scale.from);
  }
  x(value: number): number { return this.inner.x + this.inner.width * this.place(this.scales.x, value); }
  y(value: number): number { return this.inner.y + this.inner.height * (1 - this.place(this.scales.y, value)); }
  /** The value under a point of the canvas. */
  valueAt(x: number): number {
    const { from, to, log } = this.scales.x, part = (x - this.inner.x) / this.inner.width;
    return log ? from * (to / from) ** part : from + (to - from) * part;
  }

  /** An empty picture with its scales. */
  start(scales: Scales): void {
    this.scales = scales;
    const { paint, inner } = this;
    paint.clearRect(0, 0, this.size.width, this.size.height);
    paint.font = '12px system-ui, "DejaVu Sans", sans-serif';
    paint.lineWidth = 1;
    paint.strokeStyle = this.colour('faint');
    paint.fillStyle = this.colour('grey');
    if (this.margins.bottom > 16) {
      const ticks = ticksOf(scales.x, inner.width / 90);
      paint.textAlign = 'center';
      paint.textBaseline = 'top';
      ticks.forEach((value, n) => {
        const x = this.x(value), last = n === ticks.length - 1 && !scales.x.words;
        this.rule(x, inner.y, x, inner.y + inner.height);
        const number = scales.x.time ? timeText(value, scales.x, (ticks[1] ?? value + 1) - (ticks[0] ?? value)) : tickText(value);
        const text = last && !number.includes(':') ? `${number} ${scales.x.unit}` : number;
        const half = paint.measureText(text).width / 2;
        paint.fillText(text, Math.min(x, this.size.width - half - 1), inner.y + inner.height + 6);
      });
    }
    if (this.margins.left > 24) {
      paint.textAlign = 'right';
      paint.textBaseline = 'middle';
      const ticks = scales.y.words ? [] : ticksOf(scales.y, inner.height / 34);
      for (const value of ticks) {
        this.rule(inner.x, this.y(value), inner.x + inner.width, this.y(value));
        paint.fillText(tickText(value), inner.x - 6, Math.max(7, this.y(value)));
      }
      if (scales.y.unit) {
        paint.textAlign = 'left';
        paint.fillText(scales.y.unit, inner.x + 5, inner.y + 9);
      }
    }
  }

  rule(x1: number, y1: number, x2: number, y2: number): void {
    const { paint } = this;
    paint.beginPath();
    paint.moveTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
    paint.lineTo(Math.round(x2) + 0.5, Math.round(y2) + 0.5);
    paint.stroke();
  }

  line(points: readonly (readonly [number, number])[], colour: string, options: { width?: number; dash?: number[]; steps?: boolean } = {}): void {
    const { paint, inner } = this;
    paint.save();
    paint.beginPath();
    paint.rect(inner.x, inner.y, inner.width, inner.height);
    paint.clip();
    paint.beginPath();
    const line = points.map(([px, py]) => [this.x(px), this.y(py)] as const);
    let before = 0;
    (options.steps ? line : reduced(line)).forEach(([x, y], n) => {
      if (n === 0) paint.moveTo(x, y);
      else {
        if (options.steps) paint.lineTo(x, before);
        paint.lineTo(x, y);
      }
      before = y;
    });
    paint.strokeStyle = this.colour(colour);
    paint.lineWidth = options.width ?? 1.5;
    paint.setLineDash(options.dash ?? []);
    paint.lineJoin = 'round';
    paint.stroke();
    paint.restore();
  }

  bar(fromX: number, toX: number, fromY: number, toY: number, colour: string, opacity = 1): void {
    const { paint } = this;
    paint.save();
    paint.globalAlpha = opacity;
    paint.fillStyle = this.colour(colour);
    paint.fillRect(this.x(fromX), this.y(toY), Math.max(0.5, this.x(toX) - this.x(fromX)), this.y(fromY) - this.y(toY));
    paint.restore();
  }

  dot(atX: number, atY: number, colour: string): void {
    const { paint } = this;
    paint.fillStyle = this.colour(colour);
    paint.beginPath();
    paint.arc(this.x(atX), this.y(atY), 3.5, 0, 2 * Math.PI);
    paint.fill();
  }

  close(): void { this.observer.disconnect(); }
}
