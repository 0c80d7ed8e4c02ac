// Annotate: which part of a recording is which situation.
import { h } from '../dom/element';
import { pick } from '../dom/fields';
import { clock } from '../dom/number_text';
import type { SoundSet } from '../server/documents';
import { askJson } from '../server/request';
import type { Page } from '../shell/page';
import { empty } from '../shell/states';
import { workFrame } from '../shell/work_frame';
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
    const frame = workFrame('Opening the recording', (id, own, buttons) =>
      openEditor(state.recordings.find((each) => each.id === id) ?? first, rocks, state.writable, own, buttons), (id) => choose.set(id));
    const choose = pick('Recording', state.recordings.map(({ id, name, seconds, labels }) => [id, `${name} (${clock(seconds)}${labels ? ', labelled' : ''})`] as const), first.id, (id) => void frame.show(id));
    tools.replaceChildren(choose.element, frame.actions);
    place.replaceChildren(...state.problems.map((problem) => h('p', { class: 'note' }, problem)), frame.work);
    await frame.show(first.id);
    return frame.opened;
  },
};
