// Diesel: a background's model at a speed and a load, its orders, and how it sounds.
import { resume } from '../audio/output';
import { fileContext, loadSound } from '../audio/sound_files';
import { plot, scaleOf, type Series } from '../chart/plot';
import { h } from '../dom/element';
import { button, pick, slider } from '../dom/fields';
import { shown } from '../dom/number_text';
import type { SoundSet } from '../server/documents';
import { askJson } from '../server/request';
import type { Page } from '../shell/page';
import { empty } from '../shell/states';

interface Lines { hz: number[]; db: number[] }
interface Spectrum {
  rpm: number; low_rpm: number; high_rpm: number;
  points: { rpm: number; load: number; source: string }[];
  spectrum: Lines;
  orders: { order: number; hz: number; db: number }[];
  recorded: { rpm: number; spectrum: Lines } | null;
}

const kWait_ms = 120, kHeard_s = 10, kFade_s = 0.15;
const points = ({ hz, db }: Lines): [number, number][] => hz.map((x, n): [number, number] => [x, db[n] ?? 0]).filter(([x]) => x >= 20);

export const dieselPage: Page = {
  id: 'diesel', title: 'Diesel', about: 'The background’s model along speed and load',
  open: async (place) => {
    const sounds = await askJson<SoundSet>('/sound_set');
    const first = sounds.backgrounds[0];
    if (!first) {
      place.replaceChildren(empty('The sound set has no diesel yet', h('p', {}, 'rigsound background learns one from a recording of the engine along its speeds.')));
      return { close: () => undefined };
    }
    const context = await fileContext();
    let name = first.name, rpm = 0, load = 0.3, timer = 0, turn = 0, sounding = false;
    let heard: { source: AudioBufferSourceNode; gain: GainNode } | null = null;
    const note = h('p', { class: 'note', role: 'status' }), facts = h('dl', { class: 'facts' }), rows = h('tbody', {});
    const picture = plot('Spectrum', 'Stems are the orders of the diesel: multiples of its turns a second.');
    const fade = (): void => {
      if (!heard) return;
      heard.gain.gain.setTargetAtTime(0, context.currentTime, kFade_s / 3);
      heard.source.stop(context.currentTime + 2 * kFade_s);
      heard = null;
    };
    const query = (): string => `?rpm=${rpm}&load=${load}`;
    const hear = async (mine: number): Promise<void> => {
      const buffer = await loadSound(`/diesel/${name}/sound${query()}&seconds=${kHeard_s}`);
      if (mine !== turn || !sounding) return;
      fade();
      const source = new AudioBufferSourceNode(context, { buffer, loop: true }), gain = new GainNode(context, { gain: 0 });
      gain.gain.setTargetAtTime(1, context.currentTime, kFade_s / 3);
      source.connect(gain).connect(context.destination);
      source.start();
      heard = { source, gain };
    };
    const show = (given: Spectrum): void => {
      const model = points(given.spectrum), recorded = given.recorded ? points(given.recorded.spectrum) : [];
      const series: Series[] = [...(given.recorded ? [{ name: `recorded at ${given.recorded.rpm} r/min`, colour: 'second' as const, points: recorded }] : []),
        { name: 'model', colour: 'first', points: model }, { name: 'orders', colour: 'third', kind: 'stems', points: given.orders.map(({ hz, db }) => [hz, db] as const) }];
      picture.show({ x: { from: 20, to: Math.max(1000, model[model.length - 1]?.[0] ?? 1000), log: true, unit: 'Hz' },
        y: scaleOf([...model, ...recorded].map(([, db]) => db), 'dB', { floor: Math.max(...model.map(([, db]) => db)) - 90 }), series });
      facts.replaceChildren(...[['learned at', given.points.map((point) => shown(point.rpm)).join(', ') + ' r/min'], ['from', [...new Set(given.points.map(({ source }) => source))].join(', ')]]
        .map(([words, value]) => h('div', {}, h('dt', {}, words), h('dd', {}, value))));
      rows.replaceChildren(...[...given.orders].sort((a, b) => b.db - a.db).slice(0, 8).map(({ order, hz, db }) =>
        h('tr', {}, h('td', { class: 'n' }, order), h('td', { class: 'n' }, shown(hz, 0.1)), h('td', { class: 'n' }, shown(db, 0.1)))));
    };
    const update = async (): Promise<void> => {
      const mine = ++turn;
      try {
        const given = await askJson<Spectrum>(`/diesel/${name}/spectrum${query()}`);
        if (mine !== turn) return;
        note.textContent = '';
        show(given);
        if (sounding) await hear(mine);
      } catch (error) {
        if (mine === turn) note.textContent = error instanceof Error ? error.message : String(error);
      }
    };
    const soon = (): void => { clearTimeout(timer); timer = window.setTimeout(() => void update(), kWait_ms); };
    const play = button('Play', () => void toggle(), { class: 'main play', 'aria-keyshortcuts': 'Space' });
    const toggle = async (): Promise<void> => {
      sounding = !sounding;
      play.textContent = sounding ? 'Stop' : 'Play';
      await resume();
      if (sounding) await update();
      else fade();
    };
    const speed = h('div', {});
    const choose = (wanted: string): void => {
      name = wanted;
      const known = sounds.backgrounds.find((each) => each.name === wanted)?.rpm ?? [];
      const low = Math.min(...known), high = Math.max(...known);
      rpm = Math.round((low + high) / 20) * 10;
      speed.replaceChildren(slider({ label: 'Speed', unit: 'r/min', min: Math.floor(low / 10) * 10, max: Math.max(low + 10, high), step: 10, value: rpm, change: (value) => { rpm = value; soon(); } }).element);
      soon();
    };
    place.replaceChildren(note, h('section', { class: 'panel columns two', 'aria-label': 'Speed and load' },
      h('div', { class: 'form' }, sounds.backgrounds.length > 1 ? pick('Background', sounds.backgrounds.map((each) => [each.name, each.name] as const), name, choose).element : h('h2', {}, name), speed,
        slider({ label: 'Load', unit: '', min: 0, max: 1, step: 0.01, value: load, change: (value) => { load = value; soon(); } }).element, h('div', {}, play), facts),
      h('div', {}, h('h3', {}, 'Loudest orders'), h('table', {}, h('thead', {}, h('tr', {}, ...['Order', 'Hz', 'dB'].map((words) => h('th', { scope: 'col', class: 'n' }, words)))), rows))),
    picture.element);
    choose(name);
    return { shortcuts: [{ key: ' ', does: 'Play, stop', run: () => void toggle() }],
      close: () => { clearTimeout(timer); ++turn; sounding = false; fade(); picture.close(); } };
  },
};
