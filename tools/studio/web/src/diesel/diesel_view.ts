// One diesel under work: speed and load by hand, its spectrum, its sound.
import { h } from '../dom/element';
import { button, choice, slider } from '../dom/fields';
import { shown } from '../dom/number_text';
import type { Rig } from '../server/documents';
import { newest } from '../server/newest';
import { askJson } from '../server/request';
import type { Opened } from '../shell/page';
import type { Shortcut } from '../shell/shortcuts';
import { learnedSpan, speedSpan, type Diesel, type RecordedSpectrum, type Setting, type Spectrum } from './diesel';
import { openDieselSound } from './diesel_sound';
import { pointsTable } from './points_table';
import { spectrumView } from './spectrum_view';

const kNudge_rpm = 50;

export const openDiesel = async (name: string, rig: Rig, place: HTMLElement, tools: HTMLElement): Promise<Opened> => {
  const root = `/diesel/${encodeURIComponent(name)}`;
  const diesel = await askJson<Diesel>(root), span = speedSpan(diesel), learned = learnedSpan(diesel);
  const note = h('p', { class: 'note', role: 'status' }), beyond = h('p', { class: 'quiet beyond' });
  const wrong = (error: unknown): void => { if (!ending.signal.aborted) note.textContent = error instanceof Error ? error.message : String(error); };
  const ending = new AbortController(), sound = await openDieselSound(name, rig, wrong);
  const view = spectrumView(), table = pointsTable(diesel.points, (index) => go(index));
  const recordings = new Map<number, RecordedSpectrum>();
  let setting: Setting = { rpm: 0, load: 0, point: -1 }, model: Spectrum | null = null, running = false, refused = false;

  const draw = (): void => { if (model) view.show(model, recordings.get(setting.point) ?? null); };
  const modelled = newest<Setting>(async ({ rpm, load }) => {
    model = await askJson<Spectrum>(`${root}/spectrum?rpm=${rpm}&load=${load}`, { signal: ending.signal });
    draw();
    if (refused) note.textContent = '';
    refused = false;
  }, (error) => { refused = true; wrong(error); });
  const recorded = newest<number>(async (point) => {
    if (!diesel.points[point]?.recording || recordings.has(point)) return;
    reading.hidden = false;
    try {
      recordings.set(point, await askJson<RecordedSpectrum>(`${root}/recorded/${point}`, { signal: ending.signal }));
    } finally { reading.hidden = true; }
    draw();
    showHeard();
  }, wrong);

  const heard = choice('Heard', [['model', 'Model'], ['recorded', 'Recording']] as const, 'model', (which) => void hear(which));
  const reading = h('span', { class: 'quiet', role: 'status', hidden: true }, 'Reading the recording …');
  const showHeard = (): void => heard.element.querySelectorAll('input').forEach((input) => { input.disabled = !running || !recordings.has(setting.point); });
  const hear = async (which: 'model' | 'recorded'): Promise<void> => {
    const now = recordings.get(setting.point);
    if (which === 'model' || !now) return sound.playModel();
    try {
      await sound.playRecording(now);
    } catch (error) {
      heard.set('model');
      wrong(error);
    }
  };
  const where = learned.low === learned.high ? `at ${shown(learned.low)}` : `from ${shown(learned.low)} to ${shown(learned.high)}`;
  const set = (given: Setting): void => {
    // What is heard goes first; a picture takes longer.
    sound.set(given);
    sound.playModel();
    const drawn = setting.point;
    setting = given;
    if (drawn !== given.point) draw();
    speed.set(given.rpm);
    load.set(given.load);
    beyond.textContent = given.rpm < learned.low || given.rpm > learned.high ? `Learned ${where} r/min only; beyond, its colour stays.` : '';
    table.show(given.point);
    heard.set('model');
    showHeard();
    modelled.ask(given);
    if (given.point >= 0) recorded.ask(given.point);
  };
  const go = (index: number): void => {
    const point = diesel.points[index];
    if (point) set({ rpm: point.rpm, load: point.load, point: index });
  };
  const speed = slider({ label: 'Speed', unit: 'r/min', ...span, value: span.min, change: (rpm) => set({ ...setting, rpm, point: -1 }) });
  const load = slider({ label: 'Load', unit: '', min: 0, max: 1, step: 0.01, value: 0, change: (value) => set({ ...setting, load: value, point: -1 }) });
  const toggle = (): void => {
    running = !running;
    play.textContent = running ? 'Stop' : 'Start';
    sound.run(running);
    heard.set('model');
    showHeard();
  };
  const play = button('Start', toggle, { class: 'main play', 'aria-keyshortcuts': 'Space' });
  const nudge = (by: number): void => set({ ...setting, rpm: Math.max(span.min, Math.min(span.max, setting.rpm + by)), point: -1 });
  const swap = (): void => {
    const other = heard.element.querySelector<HTMLInputElement>('input:not(:checked)');
    if (other && !other.disabled) other.click();
  };

  tools.replaceChildren(play);
  place.replaceChildren(h('div', { class: 'columns three' },
    h('section', { class: 'panel form', 'aria-label': 'Speed and load' }, h('h2', {}, name), speed.element, load.element, beyond, diesel.points.some(({ recording }) => recording) ? h('div', { class: 'row' }, heard.element, reading) : null, note),
    table.element, view.table), view.picture);
  go(Math.floor(diesel.points.length / 2));
  const shortcuts: Shortcut[] = [{ key: ' ', does: 'Start, stop', run: toggle },
    { key: 'ArrowUp', does: 'Faster', run: () => nudge(kNudge_rpm) }, { key: 'ArrowDown', does: 'Slower', run: () => nudge(-kNudge_rpm) },
    ...(diesel.points.some(({ recording }) => recording) ? [{ key: 'r', does: 'Recording, model', run: swap }] : [])];
  return { shortcuts, close: () => { ending.abort(); modelled.end(); recorded.end(); sound.close(); view.close(); } };
};
