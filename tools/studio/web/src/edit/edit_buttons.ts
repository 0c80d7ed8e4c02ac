// Undo, redo and save as buttons and keys.
import { button } from '../dom/fields';
import type { Shortcut } from '../shell/shortcuts';
import type { History } from './history';

/** `worthSaving`: whether there is anything to save; as a rule, what has changed. */
export const editButtons = <T>(history: History<T>, save: () => void, writable: boolean, worthSaving = () => history.changed) => {
  const undo = button('Undo', () => history.undo(), { 'aria-keyshortcuts': 'Control+z' });
  const redo = button('Redo', () => history.redo(), { 'aria-keyshortcuts': 'Control+y' });
  const keep = button('Save', save, { class: 'main', 'aria-keyshortcuts': 'Control+s', ...(writable ? {} : { title: 'The sound set cannot be written to' }) });
  const show = (): void => {
    undo.disabled = !history.canUndo;
    redo.disabled = !history.canRedo;
    keep.disabled = !writable || !worthSaving();
  };
  show();
  const shortcuts: Shortcut[] = [{ key: 'Control+z', does: 'Undo', run: () => history.undo() },
    { key: 'Control+y', does: 'Redo', run: () => history.redo() }, { key: 'Control+s', does: 'Save', run: () => { if (!keep.disabled) save(); } }];
  return { elements: [undo, redo, keep], shortcuts, show };
};
