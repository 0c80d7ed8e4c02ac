// One recording under work: picture, parts, suggestions, sound.
import { h } from '../dom/element';
import { button, tick } from '../dom/fields';
import { onFrame } from '../dom/frames';
import { clock } from '../dom/number_text';
import { editButtons } from '../edit/edit_buttons';
import { History } from '../edit/history';
import type { Recording } from '../server/documents';
import type { Opened } from '../shell/page';
import type { Shortcut } from '../shell/shortcuts';
import { listen } from './dragging';
import { readTrack, writeTrack } from './label_track';
import { emptyPart, inOrder, kLeast_s, type Part, type Suggestion } from './part';
import { partForm } from './part_form';
import { partsTable } from './parts_table';
import { Picture } from './picture';
import { RecordingPlayer } from './recording_player';
import { partOf, suggest } from './suggestions';
import { inside, moved, showing, zoomed, type ViewRange } from './view_range';

interface Document { parts: readonly Part[]; selected: number }

export const openEditor = async (recording: Recording, rocks: string[], writable: boolean, place: HTMLElement, tools: HTMLElement): Promise<Opened> => {
  const track = await readTrack(recording.id);
  const history = new History<Document>({ parts: inOrder(track.parts), selected: -1 });
  const picture = new Picture(recording), player = new RecordingPlayer(recording), stopping = new AbortController();
  const note = h('p', { class: 'note', role: 'status' }), work = h('div', {}), asking = h('div', { class: 'row' });
  let version = track.version, cursor_s = 0, loop = false, suggestions: Suggestion[] = [], suggested = -1, chosen = -1;
  const length_s = recording.seconds, parts = (): readonly Part[] => history.value.parts;
  const wrong = (error: unknown): void => { if (!stopping.signal.aborted) note.textContent = error instanceof Error ? error.message : String(error); };

  const mark = (): void => {
    picture.marks = { parts: parts(), selected: chosen, suggestions, suggested, cursor_s, heard_s: player.position_s() };
    picture.draw();
  };
  const show = (): void => {
    if (chosen >= parts().length) chosen = -1;
    form.show(parts()[chosen] ?? null);
    table.show(parts(), chosen);
    edit.show();
    mark();
  };
  const look = (range: ViewRange): void => {
    picture.range = range;
    where.textContent = `${clock(range.from_s, 2)} to ${clock(range.to_s, 2)} of ${clock(length_s, 1)}`;
    mark();
  };
  const setCursor = (at_s: number): void => {
    cursor_s = Math.max(0, Math.min(length_s, at_s));
    look(showing(picture.range, cursor_s, length_s));
  };
  const select = (index: number): void => {
    chosen = index;
    const part = parts()[index];
    if (part && (part.to_s < picture.range.from_s || part.from_s > picture.range.to_s)) setCursor(part.from_s);
    show();
  };
  /** The changed parts in order; the selected one stays selected. */
  const change = (changed: readonly Part[], selected: number, merge = false): number => {
    const part = changed[selected], ordered = inOrder(changed);
    chosen = part ? ordered.indexOf(part) : -1;
    history.set({ parts: ordered, selected: chosen }, merge);
    return chosen;
  };
  const remove = (index: number): void => { if (parts()[index]) void change(parts().filter((_, n) => n !== index), -1); };
  const add = (): void => {
    const span = picture.range.to_s - picture.range.from_s, part = emptyPart(cursor_s, Math.min(length_s, cursor_s + Math.max(kLeast_s, span / 10)));
    if (part.to_s - part.from_s >= kLeast_s) change([...parts(), part], parts().length);
  };
  const edge = (which: 'from_s' | 'to_s'): void => {
    const part = parts()[chosen];
    if (!part) return;
    const moved_ = { ...part, [which]: cursor_s };
    if (moved_.to_s - moved_.from_s >= kLeast_s) change(parts().map((each, n) => (n === chosen ? moved_ : each)), chosen);
  };

  const play = button('Play', () => toggle(), { class: 'play', 'aria-keyshortcuts': 'Space' });
  const toggle = (): void => {
    if (player.playing) player.stop();
    else {
      const part = loop ? parts()[chosen] ?? suggestions[suggested] : undefined;
      player.play(part ? part.from_s : cursor_s >= length_s - 0.01 ? 0 : cursor_s, part ? part.to_s : null).catch((error) => { player.stop(); showPlay(); wrong(error); });
    }
    showPlay();
  };
  const showPlay = (): void => { play.textContent = player.playing ? 'Stop' : 'Play'; mark(); };
  player.onEnd = showPlay;
  const looping = tick('Loop the selected part', false, (on) => { loop = on; if (player.playing) { toggle(); toggle(); } });
  const setLoop = (): void => { loop = !loop; looping.set(loop); };

  const showSuggestions = (): void => {
    if (suggested >= suggestions.length) suggested = suggestions.length - 1;
    asking.replaceChildren(...(suggestions.length === 0
      ? [button('Suggest parts', () => void find(), { 'aria-keyshortcuts': 'g' })]
      : [h('span', {}, `Suggestion ${suggested + 1} of ${suggestions.length}`), button('Accept', () => decide(true), { 'aria-keyshortcuts': 'a' }),
        button('Reject', () => decide(false), { 'aria-keyshortcuts': 'x' }), button('Next', () => step(1), { 'aria-keyshortcuts': 'f' }),
        button('Accept all', () => acceptAll()), button('Reject all', () => { suggestions = []; showSuggestions(); })]));
    const now = suggestions[suggested];
    if (now && (now.to_s < picture.range.from_s || now.from_s > picture.range.to_s)) setCursor(now.from_s);
    mark();
  };
  const find = async (): Promise<void> => {
    asking.replaceChildren();
    try {
      suggestions = await suggest(recording.id, work, stopping.signal);
      suggested = suggestions.length ? 0 : -1;
      note.textContent = suggestions.length ? '' : 'No part was found whose clicks come in a rhythm.';
    } catch (error) { wrong(error); }
    if (!stopping.signal.aborted) showSuggestions();
  };
  const step = (by: number): void => {
    if (suggestions.length) suggested = (suggested + by + suggestions.length) % suggestions.length;
    showSuggestions();
  };
  const decide = (accept: boolean): void => {
    const now = suggestions[suggested];
    if (!now) return;
    suggestions = suggestions.filter((each) => each !== now);
    if (accept) change([...parts(), partOf(now)], parts().length);
    showSuggestions();
  };
  const acceptAll = (): void => {
    change([...parts(), ...suggestions.map(partOf)], -1);
    suggestions = [];
    showSuggestions();
  };

  const save = async (): Promise<void> => {
    try {
      const saving = history.value;
      const written = await writeTrack(recording.id, version, parts());
      if (written.kind === 'changed')
        return note.replaceChildren('The label track was changed elsewhere in the meantime.',
          button('Take theirs', () => void takeTheirs()), button('Keep mine', () => { version = written.version; void save(); }));
      version = written.track.version;
      if (history.value === saving) history.markSaved();
      note.textContent = `Saved beside ${recording.name}; the version before is kept as .bak.`;
    } catch (error) { wrong(error); }
  };
  const takeTheirs = async (): Promise<void> => {
    try {
      const theirs = await readTrack(recording.id);
      version = theirs.version;
      history.set({ parts: inOrder(theirs.parts), selected: -1 });
      history.markSaved();
      note.textContent = 'Theirs is shown. Undo brings your own back.';
    } catch (error) { wrong(error); }
  };

  const edit = editButtons(history, () => void save(), writable);
  const form = partForm(rocks, length_s, (part) => { change(parts().map((each, n) => (n === chosen ? part : each)), chosen); });
  const table = partsTable(select, remove);
  const where = h('output', { class: 'quiet' });
  history.onChange = ({ selected }) => { chosen = selected; show(); };
  listen(picture, parts, length_s, { select, setCursor, change,
    zoom: (factor, at_s) => look(zoomed(picture.range, factor, at_s, length_s)), pan: (by_s) => look(moved(picture.range, by_s, length_s)) });
  const zoom = (factor: number): void => {
    const { from_s, to_s } = picture.range, middle = cursor_s >= from_s && cursor_s <= to_s ? cursor_s : (from_s + to_s) / 2;
    look(zoomed(picture.range, factor, middle, length_s));
  };
  const span = (): number => picture.range.to_s - picture.range.from_s;
  const whole = (): void => look({ from_s: 0, to_s: length_s });
  const frames = onFrame(() => {
    const at = player.position_s();
    if (at === null) return;
    if (at > picture.range.to_s) look(inside({ from_s: at, to_s: at + span() }, length_s));
    mark();
  });

  tools.replaceChildren(...edit.elements);
  place.replaceChildren(note, ...track.problems.map((problem) => h('p', { class: 'note' }, problem)),
    h('section', { class: 'panel', 'aria-label': 'Recording' },
      h('div', { class: 'row' }, play, looping.element, h('span', { class: 'grow' }), where, button('−', () => zoom(1.6), { 'aria-label': 'Zoom out' }),
        button('+', () => zoom(1 / 1.6), { 'aria-label': 'Zoom in' }), button('All', whole)),
      picture.wave.element, picture.sonagram.element, h('div', { class: 'row' }, button('New part', add, { 'aria-keyshortcuts': 'n' }), asking, h('div', { class: 'grow' }, work))),
    h('section', { class: 'panel stack', 'aria-label': 'Parts' }, form.element, table.element));
  showSuggestions();
  look(picture.range);
  show();
  const shortcuts: Shortcut[] = [
    { key: ' ', does: 'Play, stop', run: toggle }, { key: 'l', does: 'Loop the selected part', run: setLoop },
    { key: 'ArrowLeft', does: 'Cursor back', run: () => setCursor(cursor_s - span() / 100) }, { key: 'ArrowRight', does: 'Cursor on', run: () => setCursor(cursor_s + span() / 100) },
    { key: 'PageUp', does: 'View back', run: () => look(moved(picture.range, -0.8 * span(), length_s)) },
    { key: 'PageDown', does: 'View on', run: () => look(moved(picture.range, 0.8 * span(), length_s)) },
    { key: '+', does: 'Zoom in', run: () => zoom(1 / 1.6) }, { key: '-', does: 'Zoom out', run: () => zoom(1.6) }, { key: '0', does: 'See all of it', run: whole },
    { key: 'n', does: 'New part at the cursor', run: add }, { key: '[', does: 'Part begins at the cursor', run: () => edge('from_s') },
    { key: ']', does: 'Part ends at the cursor', run: () => edge('to_s') }, { key: ',', does: 'Part before', run: () => select(Math.max(0, chosen - 1)) },
    { key: '.', does: 'Next part', run: () => select(Math.min(parts().length - 1, chosen + 1)) }, { key: 'Delete', does: 'Remove the part', run: () => remove(chosen) },
    { key: 'g', does: 'Suggest parts', run: () => { if (suggestions.length === 0) void find(); } }, { key: 'a', does: 'Accept the suggestion', run: () => decide(true) },
    { key: 'x', does: 'Reject the suggestion', run: () => decide(false) }, { key: 'f', does: 'Next suggestion', run: () => step(1) }, ...edit.shortcuts];
  return {
    shortcuts, unsaved: () => (history.changed ? `The parts of ${recording.name} are not saved.` : null),
    close: () => { stopping.abort(); frames(); player.stop(); picture.close(); },
  };
};
