// Refine: the six controls, the clicks and the level of a bank, heard at once from the engine, saved beside the bank.
import type { Bank, Refinement } from '../bank/bank_document';
import { bankList, noBanks } from '../bank/bank_list';
import { outputAt, resume } from '../audio/output';
import { RigPlayer } from '../audio/rig_player';
import { spectrumView } from '../audio/scope';
import { servedParts } from '../audio/served_parts';
import { soundFor } from '../audio/sound_files';
import { h } from '../dom/element';
import { button, slider, type Field } from '../dom/fields';
import { editButtons } from '../edit/edit_buttons';
import { History } from '../edit/history';
import { controlSlider } from '../rig/controls';
import type { Rig, SoundSet } from '../server/documents';
import { askBytes, askJson, ServerError } from '../server/request';
import type { Opened, Page } from '../shell/page';
import { workFrame } from '../shell/work_frame';
import { clickGrid } from './click_grid';
import { changesOf, neutralOf, packedPath } from './refinement';

const kTrim = { min: -60, max: 24 };

const openBank = async (name: string, rig: Rig, writable: boolean, work: HTMLElement, tools: HTMLElement): Promise<Opened> => {
  const bank = await askJson<Bank>(`/banks/${name}`);
  const clicks = bank.clicks.map(({ index }) => index);
  const history = new History<Refinement>(bank.refinement);
  const context = await outputAt(rig.rate);
  const player = await RigPlayer.open(context, await servedParts(), await askBytes(packedPath(name, clicks, bank.refinement.dropped)));
  player.change({ call: 'set', name: 'feed_pressure_bar', boom: 0, value: Math.round((rig.feed.underfeed_bar + rig.feed.overfeed_bar) / 2) });
  const scope = spectrumView(player.node), note = h('p', { class: 'note', role: 'status' });
  player.onProblem = (line) => { note.textContent = line; };

  let sounding = false, moving = '', droppedNow = bank.refinement.dropped.join(), version = bank.refinement.version;
  const sound = (wanted: boolean): void => {
    sounding = wanted;
    void resume();
    if (wanted) player.node.connect(context.destination);
    else player.node.disconnect(context.destination);
    play.textContent = wanted ? 'Stop' : 'Play';
  };
  const play = button('Play', () => sound(!sounding), { class: 'play', 'aria-keyshortcuts': 'Space' });

  const turn = (key: string, change: Partial<Refinement>): void => {
    history.set({ ...history.value, ...change }, moving === key);
    moving = key;
  };
  const fields = new Map<string, Field<number>>(rig.controls.map((control) => [control.name, controlSlider(control, control.neutral,
    (value) => turn(control.name, { controls: { ...history.value.controls, [control.name]: value } }))]));
  const trim = slider({ label: 'Level trim', unit: 'dB', ...kTrim, step: 0.5, value: 0, change: (value) => turn('trim', { trim_db: value }) });
  const grid = clickGrid(clicks, (index) => void hearClick(index), (index, dropped) => {
    moving = '';
    const kept = history.value.dropped.filter((each) => each !== index);
    history.set({ ...history.value, dropped: dropped ? [...kept, index].sort((a, b) => a - b) : kept });
  });
  const hearClick = async (index: number): Promise<void> => {
    try {
      const source = new AudioBufferSourceNode(context, { buffer: await soundFor(context, `/banks/${name}/clicks/${index}`) });
      await resume();
      source.connect(context.destination);
      source.start();
    } catch (error) {
      note.textContent = error instanceof Error ? error.message : String(error);
    }
  };
  const reload = async (dropped: number[]): Promise<void> => {
    const set = await askBytes(packedPath(name, clicks, dropped));
    if (history.value.dropped.join() === dropped.join()) void player.load(set);
  };
  const show = (value: Refinement): void => {
    fields.forEach((field, control) => field.set(value.controls[control] ?? rig.controls.find((each) => each.name === control)?.neutral ?? 0));
    trim.set(value.trim_db);
    grid.show(value.dropped);
    changesOf(value, rig.controls).forEach((change) => player.change(change));
    if (value.dropped.join() !== droppedNow) {
      droppedNow = value.dropped.join();
      reload(value.dropped).catch((error: Error) => { note.textContent = error.message; });
    }
    edit.show();
  };

  const write = async (method: string, path: string, body?: unknown): Promise<void> => {
    try {
      const saved = await askJson<Refinement>(path, { method, ...(body ? { body } : {}) });
      version = saved.version;
      if (method === 'DELETE') history.set({ ...saved });
      history.markSaved();
      note.replaceChildren(method === 'DELETE' ? 'Back at the analysed values. Undo brings your own back.' : 'Saved.');
    } catch (error) {
      if (error instanceof ServerError && error.status === 409)
        note.replaceChildren('This bank was refined elsewhere in the meantime.', button('Take theirs', () => void takeTheirs()),
          button('Keep mine', () => { version = String(error.answer.version); void save(); }));
      else note.textContent = error instanceof Error ? error.message : String(error);
    }
  };
  const save = (): Promise<void> => {
    moving = '';
    const { controls, dropped, trim_db } = history.value;
    return write('PUT', `/banks/${name}/refinement`, { version, controls, dropped, trim_db });
  };
  const takeTheirs = async (): Promise<void> => {
    const { refinement } = await askJson<Bank>(`/banks/${name}`);
    version = refinement.version;
    history.set(refinement);
    history.markSaved();
    note.textContent = 'Theirs is shown. Undo brings your own back.';
  };
  const edit = editButtons(history, () => void save(), writable);
  const back = button('Back to analysed', () => {
    if (version === 'absent') history.set(neutralOf(rig.controls, version));
    else void write('DELETE', `/banks/${name}/refinement?version=${encodeURIComponent(version)}`);
  });
  history.onChange = show;
  tools.replaceChildren(back, ...edit.elements);
  work.replaceChildren(note, h('div', { class: 'columns two' },
    h('section', { class: 'panel stack', 'aria-label': 'Controls' }, h('div', { class: 'row' }, h('h2', { class: 'grow' }, name), play),
      ...[...fields.values()].map(({ element }) => element), trim.element),
    h('div', { class: 'stack' }, h('div', { class: 'panel' }, scope.element),
      h('section', { class: 'panel', 'aria-label': 'Clicks' }, h('h2', {}, 'Clicks in the bank'), grid.element))));
  show(history.value);
  return {
    shortcuts: [{ key: ' ', does: 'Play, stop', run: () => sound(!sounding) }, ...edit.shortcuts],
    unsaved: () => (history.changed ? `The refinement of ${name} is not saved.` : null),
    close: () => { scope.close(); player.close(); },
  };
};

export const refinePage: Page = {
  id: 'refine', title: 'Refine', about: 'Six controls, clicks and level of a bank, by ear',
  open: async (place, tools, state) => {
    const [sounds, rig] = await Promise.all([askJson<SoundSet>('/sound_set'), askJson<Rig>('/rig')]);
    const first = sounds.banks[0];
    if (!first) {
      place.replaceChildren(noBanks());
      return { close: () => undefined };
    }
    const frame = workFrame('Reading the bank', (name, own, buttons) => openBank(name, rig, state.writable, own, buttons), (name) => list.show(name));
    const list = bankList(sounds, (name) => void frame.show(name));
    tools.replaceChildren(frame.actions);
    place.replaceChildren(h('div', { class: 'columns with-list' }, list.element, frame.work));
    void frame.show(first.name);
    return frame.opened;
  },
};
