// Steel: a bar of some length and diameter, the modes it wants and the modes the engine reaches, heard.
import { fileContext, loadSound } from '../audio/sound_files';
import { resume } from '../audio/output';
import { plot, scaleOf } from '../chart/plot';
import { h } from '../dom/element';
import { button, pick, slider, tick } from '../dom/fields';
import { shown } from '../dom/number_text';
import type { SoundSet } from '../server/documents';
import { askJson, ServerError } from '../server/request';
import type { Page } from '../shell/page';

interface Mode { family: string; mode: number; target_hz: number; model_hz: number; error_cents: number; t60_s: number }
interface Decay { low_hz: number; low_s: number; high_hz: number; high_s: number }
interface Steel { length_m: number; diameter_m: number; transversal: Decay | null; longitudinal: null }

const kWait_ms = 180, kLeastName = /^[A-Za-z0-9][A-Za-z0-9_.-]*$/;

export const steelPage: Page = {
  id: 'steel', title: 'Steel', about: 'A bar, its modes, and how it rings',
  open: async (place, tools, state) => {
    const sounds = await askJson<SoundSet>('/sound_set');
    const context = await fileContext();
    let steel: Steel = { length_m: 0.5, diameter_m: 0.025, transversal: null, longitudinal: null };
    let decay: Decay = { low_hz: 500, low_s: 0.4, high_hz: 8000, high_s: 0.05 };
    let timer = 0, turn = 0, bank = '';
    let playing: AudioBufferSourceNode | null = null;
    const note = h('p', { class: 'note', role: 'status' }), rows = h('tbody', {});
    const modes = plot('Modes of the bar', 'A stem is a wanted mode, a dot the mode that the engine’s tool has; height is the time to fall by 60 dB.');
    const wrong = (error: unknown): void => { note.textContent = error instanceof Error ? error.message : String(error); };

    const show = (given: Mode[]): void => {
      const best = given.filter(({ target_hz }) => target_hz < 20000);
      modes.show({ x: { from: 100, to: 20000, log: true, unit: 'Hz' }, y: scaleOf(best.map(({ t60_s }) => t60_s), 's', { zero: true }),
        series: [{ name: 'wanted', colour: 'second', kind: 'stems', points: best.map(({ target_hz, t60_s }) => [target_hz, t60_s] as const) },
          { name: 'reached', colour: 'first', kind: 'dots', points: best.map(({ model_hz, t60_s }) => [model_hz, t60_s] as const) }] });
      rows.replaceChildren(...given.map((mode) => h('tr', {}, h('td', {}, mode.family), h('td', { class: 'n' }, mode.mode),
        h('td', { class: 'n' }, shown(mode.target_hz, 0.1)), h('td', { class: 'n' }, shown(mode.model_hz, 0.1)),
        h('td', { class: 'n' }, shown(mode.error_cents, 0.1)), h('td', { class: 'n' }, shown(mode.t60_s, 0.01)))));
    };
    const compute = async (): Promise<void> => {
      const mine = ++turn;
      try {
        const { modes: found } = await askJson<{ modes: Mode[] }>('/steel', { method: 'POST', body: steel });
        if (mine !== turn) return;
        note.textContent = '';
        show(found);
      } catch (error) {
        if (mine === turn) wrong(error);
      }
    };
    const change = (part: Partial<Steel>): void => {
      steel = { ...steel, ...part };
      clearTimeout(timer);
      timer = window.setTimeout(() => void compute(), kWait_ms);
    };
    const silence = (): void => { playing?.stop(); playing = null; };
    const hear = async (what: 'blow' | 'drilling'): Promise<void> => {
      silence();
      try {
        await resume();
        const body = { ...steel, what, seconds: what === 'blow' ? 3 : 8, ...(what === 'drilling' && bank ? { bank } : {}) };
        playing = new AudioBufferSourceNode(context, { buffer: await loadSound('/steel/sound', { method: 'POST', body }) });
        playing.connect(context.destination);
        playing.start();
      } catch (error) { wrong(error); }
    };

    const decayFields = h('div', { class: 'form' },
      slider({ label: 'Decay at 500 Hz', unit: 's', min: 0.02, max: 3, step: 0.01, value: decay.low_s, change: (value) => { decay = { ...decay, low_s: value }; change({ transversal: decay }); } }).element,
      slider({ label: 'Decay at 8 kHz', unit: 's', min: 0.01, max: 1, step: 0.01, value: decay.high_s, change: (value) => { decay = { ...decay, high_s: value }; change({ transversal: decay }); } }).element);
    decayFields.hidden = true;
    const own = tick('Set the decay', false, (on) => { decayFields.hidden = !on; change({ transversal: on ? decay : null }); });

    const name = h('input', { type: 'text', id: 'steel-name', value: 'steel_500x25', autocomplete: 'off' });
    const save = async (): Promise<void> => {
      if (!kLeastName.test(name.value)) return wrong('A name has letters, digits, _ - and . only.');
      const known = sounds.tools.find((tool) => tool.name === name.value);
      if (known && !confirm(`Replace the tool ${name.value}?`)) return;
      try {
        const saved = await askJson<{ name: string; version: string }>(`/tools/${name.value}`, { method: 'PUT', body: { ...steel, version: known?.version ?? 'absent' } });
        sounds.tools = [...sounds.tools.filter((tool) => tool.name !== saved.name), { name: saved.name, kind: 'bar', version: saved.version }];
        note.textContent = `Saved as ${saved.name}. A [[boom]] takes it by tool = "${saved.name}".`;
      } catch (error) {
        wrong(error instanceof ServerError && error.status === 409 ? 'A tool of that name was saved elsewhere in the meantime. Choose another name.' : error);
      }
    };
    tools.replaceChildren(h('label', { for: 'steel-name' }, 'Name'), name, button('Save', () => void save(), { class: 'main', disabled: !state.writable }));
    place.replaceChildren(note, h('div', { class: 'columns two' },
      h('section', { class: 'panel form', 'aria-label': 'Bar' },
        slider({ label: 'Length', unit: 'm', min: 0.1, max: 6, step: 0.01, value: steel.length_m, change: (value) => change({ length_m: value }) }).element,
        slider({ label: 'Diameter', unit: 'm', min: 0.01, max: 0.1, step: 0.001, value: steel.diameter_m, change: (value) => change({ diameter_m: value }) }).element,
        own.element, decayFields,
        h('div', { class: 'row' }, button('One blow', () => void hear('blow'), { 'aria-keyshortcuts': 'b' }), button('Drilling', () => void hear('drilling'), { 'aria-keyshortcuts': 'd' }), button('Stop', silence)),
        sounds.banks.length ? pick('Impacts of', [['', '24 a second'], ...sounds.banks.map((each) => [each.name, each.name] as const)], '', (value) => { bank = value; }).element : null),
      modes.element),
    h('div', { class: 'panel wide' }, h('table', {}, h('thead', {}, h('tr', {}, ...['Family', 'Mode', 'Wanted, Hz', 'Reached, Hz', 'Off by, cents', 'Falls by 60 dB in, s']
      .map((words, n) => h('th', { scope: 'col', class: n ? 'n' : '' }, words)))), rows)));
    await compute();
    return { shortcuts: [{ key: 'b', does: 'One blow', run: () => void hear('blow') }, { key: 'd', does: 'Drilling', run: () => void hear('drilling') }],
      close: () => { clearTimeout(timer); silence(); modes.close(); } };
  },
};
