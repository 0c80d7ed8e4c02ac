// Live: a running daemon, as it says itself, and its controls.
import { h } from '../dom/element';
import { button } from '../dom/fields';
import { clock, shown } from '../dom/number_text';
import type { Rig } from '../server/documents';
import { askJson, askLines } from '../server/request';
import type { Page } from '../shell/page';
import { empty } from '../shell/states';
import { boomCard } from './boom_card';
import { merged, type Json } from './merge_patch';
import type { LiveEvent, LiveSignal, Status } from './status';

const kAgesEvery_ms = 1000, kAgain_ms = 1500;
const kGone = 'The daemon is gone';
const gone = (why: string): string => `${kGone}: ${why}. Asking again; below is what it said last.`;
interface FullStatus { ok: boolean; signals: (LiveSignal & { name: string })[]; audio: NonNullable<Status['audio']> }

const tidy = (value: number): string => String(+value.toFixed(2)).replace('-', '−');

const signalRow = ([name, signal]: [string, LiveSignal], age: number | null | undefined): HTMLElement => {
  const stale = !['valid', 'ok', 'manual', 'never', 'absent', 'good'].includes(signal.validity);
  return h('tr', { class: stale ? 'stale' : '' }, h('td', {}, name), h('td', { class: 'n' }, signal.word ? signal.word : `${tidy(signal.value)} ${signal.unit}`.trim()),
    h('td', { class: 'n' }, age === null || age === undefined ? '–' : `${shown(age, 0.1)} s`), h('td', {}, signal.validity), h('td', { class: 'n' }, (signal.refused ?? 0) + (signal.clamped ?? 0) || '–'));
};

export const livePage: Page = {
  id: 'live', title: 'Live', about: 'A running daemon, and its controls',
  open: async (place, tools, state) => {
    if (!state.daemon) {
      place.replaceChildren(empty('No daemon is connected', h('p', {}, 'Start the studio with --daemon and the control socket of a running rigsoundd, such as /run/rigsound/control.sock.')));
      return { close: () => undefined };
    }
    const rig = await askJson<Rig>('/rig');
    const closing = new AbortController();
    let status: Status = {}, ages = new Map<string, number | null>(), load = '';
    const note = h('p', { class: 'note', role: 'status' }), facts = h('dl', { class: 'facts' }), rows = h('tbody', {}), booms = h('div', { class: 'stack' });
    const level = h('meter', { min: -60, max: 0, 'aria-label': 'Level' }), levelText = h('output', {}), limiter = h('meter', { min: 0, max: 12, 'aria-label': 'Limiter' }), limiterText = h('output', {});
    const cards = new Map<string, ReturnType<typeof boomCard>>();
    const tell = async (body: Record<string, unknown>): Promise<void> => {
      try {
        const answer = await askJson<{ ok: boolean; error?: string }>('/live', { method: 'POST', body });
        note.textContent = answer.ok ? '' : answer.error ?? 'The daemon refused.';
      } catch (error) { note.textContent = error instanceof Error ? error.message : String(error); }
    };
    const mute = button('Mute', () => void tell({ command: 'mute', on: !status.muted }), { 'aria-keyshortcuts': 'm' });
    const release = button('Release all', () => void tell({ command: 'release', key: 'all' }));
    const show = (): void => {
      const { audio, meters } = status;
      mute.textContent = status.muted ? 'Unmute' : 'Mute';
      mute.setAttribute('aria-pressed', String(status.muted === true));
      facts.replaceChildren(...([['rig', status.rig], ['card', audio?.card || (audio?.playing ? 'playing' : 'none')], ['underruns', audio?.xruns], ['deadline misses', audio?.deadline_misses],
        ['load', load], ['lost clicks', meters?.lost_clicks], ['up', status.uptime_s === undefined ? undefined : clock(status.uptime_s)],
        ...Object.entries(status.buses ?? {}).map(([name, bus]) => [name, bus.up ? 'up' : bus.problem || 'down'])] as [string, unknown][])
        .filter(([, value]) => value !== undefined && value !== '').map(([key, value]) => h('div', {}, h('dt', {}, key), h('dd', {}, String(value)))));
      level.value = Math.max(-60, meters?.rms_db ?? -60);
      levelText.textContent = meters && meters.rms_db > -120 ? `${shown(meters.rms_db, 0.1)} dB` : '−∞ dB';
      limiter.value = -(meters?.limiter_db ?? 0);
      limiterText.textContent = `${shown(meters?.limiter_db ?? 0, 0.1)} dB`;
      rows.replaceChildren(...Object.entries(status.signals ?? {}).map((entry) => signalRow(entry, ages.get(entry[0]))));
      for (const [name, boom] of Object.entries(status.booms ?? {})) {
        let card = cards.get(name);
        if (!card) {
          cards.set(name, card = boomCard(name, rig.controls, (control, value) => void tell({ command: 'set', key: `${name}.${control}`, value })));
          booms.append(card.element);
        }
        card.show(boom);
      }
    };
    const take = (event: LiveEvent): void => {
      if (!('event' in event)) return;
      if (event.event === 'gone') {
        note.textContent = gone(event.error);
        return;
      }
      if (note.textContent?.startsWith(kGone)) note.textContent = '';
      status = merged(status as unknown as Json, event.change as unknown as Json) as unknown as Status;
      status.uptime_s = event.uptime_s;
      show();
    };
    const follow = async (): Promise<void> => {
      while (!closing.signal.aborted) {
        try {
          for await (const event of askLines<LiveEvent>('/live/events', closing.signal)) take(event);
        } catch (error) {
          if (closing.signal.aborted) return;
          note.textContent = gone(error instanceof Error ? error.message : String(error));
        }
        await new Promise((done) => setTimeout(done, kAgain_ms));
      }
    };
    // The events leave out what grows with every block.
    const poll = setInterval(() => {
      askJson<FullStatus>('/live', { method: 'POST', body: { command: 'status' } }).then((full) => {
        if (!full.ok || closing.signal.aborted) return;
        ages = new Map(full.signals.map(({ name, age_s }) => [name, age_s ?? null]));
        load = full.audio.load === undefined ? '' : `${shown(100 * full.audio.load, 0.1)} %`;
        show();
      }, () => undefined);
    }, kAgesEvery_ms);
    tools.replaceChildren(release, mute);
    place.replaceChildren(note, h('section', { class: 'panel stack', 'aria-label': 'Sound' }, h('div', { class: 'columns two' },
      h('div', { class: 'meter' }, h('span', {}, 'Level'), level, levelText), h('div', { class: 'meter' }, h('span', {}, 'Limiter'), limiter, limiterText)), facts), booms,
    h('section', { class: 'panel wide signals', 'aria-label': 'Signals' }, h('h2', {}, 'Signals'), h('table', {},
      h('thead', {}, h('tr', {}, ...['Signal', 'Value', 'Age', 'Validity', 'Refused'].map((words, n) => h('th', { scope: 'col', class: n === 1 || n === 2 || n === 4 ? 'n' : '' }, words)))), rows)));
    void follow();
    return { shortcuts: [{ key: 'm', does: 'Mute, unmute', run: () => mute.click() }], close: () => { closing.abort(); clearInterval(poll); } };
  },
};
