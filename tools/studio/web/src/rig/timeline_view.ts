// A bus log along its time: the situation as a strip, feed and speed as curves, the place that is heard as a line.
import { Surface } from '../chart/surface';
import { h } from '../dom/element';
import { clock } from '../dom/number_text';
import type { Timeline } from '../server/documents';
import { situationWords } from './situation_words';

const kMargins = { left: 48, right: 14, top: 6, bottom: 4 };

export class TimelineView {
  readonly element: HTMLElement;
  private readonly strip = new Surface('Situation along the log', { ...kMargins, top: 2, bottom: 2 });
  private readonly curves = new Surface('Feed pressure and diesel speed along the log', { ...kMargins, bottom: 26 });
  private at = 0;

  constructor(private readonly timeline: Timeline, private readonly boom: number, seek: (seconds: number) => void) {
    this.strip.element.classList.add('strip');
    const seen = [...new Set((timeline.situations.find((each) => each.boom === boom)?.changes ?? []).map(([, name]) => name))];
    this.element = h('div', { class: 'timeline stack' }, this.strip.element, this.curves.element,
      h('ul', { class: 'legend' }, ...seen.filter(Boolean).map((name) => h('li', { class: `mark is-${name}` }, situationWords(name))),
        h('li', { class: 'mark-first' }, 'feed, bar'), h('li', { class: 'mark-third' }, 'diesel, r/min ÷ 10')),
      ...timeline.notes.map((note) => h('p', { class: 'note' }, note)));
    for (const surface of [this.strip, this.curves]) {
      surface.onResize = () => this.draw();
      surface.canvas.addEventListener('click', (event) => {
        const wanted = surface.valueAt(event.offsetX);
        seek(Math.max(0, Math.min(timeline.seconds, wanted)));
      });
    }
  }

  show(seconds: number): void {
    this.at = seconds;
    this.draw();
  }

  private steps(name: string, factor: number): [number, number][] {
    const signal = this.timeline.signals.find((each) => each.name === name && (each.boom === this.boom || each.boom === 0));
    const points = (signal?.changes ?? []).map(([time, value]): [number, number] => [time, (value ?? 0) * factor]);
    const last = points[points.length - 1];
    return last ? [...points, [this.timeline.seconds, last[1]]] : points;
  }

  private draw(): void {
    const { timeline } = this, x = { from: 0, to: Math.max(0.1, timeline.seconds), unit: 's', time: true };
    this.strip.start({ x, y: { from: 0, to: 1, unit: '', words: [] } });
    const situations = timeline.situations.find((each) => each.boom === this.boom)?.changes ?? [];
    situations.forEach(([from, name], n) => name && this.strip.bar(from, situations[n + 1]?.[0] ?? timeline.seconds, 0, 1, name, 0.95));
    this.curves.start({ x, y: { from: 0, to: 300, unit: '' } });
    this.curves.line(this.steps('engine_rpm', 0.1), 'third', { steps: true });
    this.curves.line(this.steps('feed_pressure_bar', 1), 'first', { steps: true });
    for (const surface of [this.strip, this.curves]) surface.bar(this.at, this.at, 0, 300, 'ink'), surface.line([[this.at, 0], [this.at, 300]], 'ink', { width: 2 });
    this.curves.canvas.setAttribute('aria-label', `Feed pressure and diesel speed along the log, at ${clock(this.at, 1)}`);
  }

  close(): void { this.strip.close(); this.curves.close(); }
}
