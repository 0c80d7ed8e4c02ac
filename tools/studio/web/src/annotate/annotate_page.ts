// Annotate: which part of a recording is which situation.
import { h } from '../dom/element';
import { pick } from '../dom/fields';
import { clock } from '../dom/number_text';
import type { SoundSet } from '../server/documents';
import { askJson } from '../server/request';
import type { Opened, Page } from '../shell/page';
import type { Shortcut } from '../shell/shortcuts';
import { empty, failed, loading } from '../shell/states';
import { openEditor } from './editor';

/** Where a page has no recording to work on. */
export const noRecordings = (): HTMLElement => empty('There are no recordings',
  h('p', {}, 'Start the studio with --recordings and the folder that holds them: WAV, FLAC, OGG or anything else libsndfile reads.'));

export const annotatePage: Page = {
  id: 'annotate', title: 'Annotate', about: 'Which part of a recording is which situation',
  open: async (place, tools, state) => {
    const first = state.recordings[0];
    if (!first) {
      place.replaceChildren(noRecordings());
      return { close: () => undefined };
    }
    const sounds = await askJson<SoundSet>('/sound_set');
    const rocks = sounds.rocks.map(({ name }) => name).filter(Boolean);
    const work = h('div', { class: 'stack' }), actions = h('div', { class: 'row' }), shortcuts: Shortcut[] = [];
    let opened: Opened | null = null, turn = 0, here = first.id;
    const show = async (id: string): Promise<void> => {
      const recording = state.recordings.find((each) => each.id === id), lost = opened?.unsaved?.();
      if (!recording) return;
      if (lost && !confirm(`${lost} Leave them all the same?`)) return choose.set(here);
      const mine = ++turn;
      here = id;
      opened?.close();
      opened = null;
      work.replaceChildren(loading('Opening the recording'));
      try {
        // Another recording may be chosen before this one is there.
        const own = h('div', { class: 'stack' }), buttons = h('div', { class: 'row' });
        const made = await openEditor(recording, rocks, state.writable, own, buttons);
        if (mine !== turn) return made.close();
        opened = made;
        work.replaceChildren(own);
        actions.replaceChildren(buttons);
        shortcuts.splice(0, shortcuts.length, ...(made.shortcuts ?? []));
      } catch (error) {
        if (mine === turn) work.replaceChildren(failed(error, () => void show(id)));
      }
    };
    const choose = pick('Recording', state.recordings.map(({ id, name, seconds, labels }) => [id, `${name} (${clock(seconds)}${labels ? ', labelled' : ''})`] as const), first.id, (id) => void show(id));
    tools.replaceChildren(choose.element, actions);
    place.replaceChildren(...state.problems.map((problem) => h('p', { class: 'note' }, problem)), work);
    await show(first.id);
    return { shortcuts, unsaved: () => opened?.unsaved?.() ?? null, close: () => { ++turn; opened?.close(); } };
  },
};
