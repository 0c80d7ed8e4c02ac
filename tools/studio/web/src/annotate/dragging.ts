// Parts under the pointer: an edge is moved, a middle moved as a whole, a drag over nothing makes a new part, a click sets the
// cursor.
import { emptyPart, kLeast_s, type Part } from './part';
import type { Picture } from './picture';

export interface Dragged {
  select(index: number): void;
  setCursor(at_s: number): void;
  /** `merge`: still the same drag. Gives the place of the selected part in the new order. */
  change(parts: Part[], selected: number, merge: boolean): number;
  zoom(factor: number, at_s: number): void;
  pan(by_s: number): void;
}

const kEdge_px = 6, kDrag_px = 4;
type Grip = { kind: 'from' | 'to' | 'whole'; index: number; start: Part } | { kind: 'new' };

export const listen = (picture: Picture, parts: () => readonly Part[], length_s: number, to: Dragged): void => {
  const grip = (at_s: number): Grip => {
    const near = picture.width_s(kEdge_px), all = parts(), order = [picture.marks.selected, ...all.keys()].filter((n) => all[n]);
    for (const index of order) {
      const start = all[index] as Part;
      if (Math.abs(start.from_s - at_s) < near) return { kind: 'from', index, start };
      if (Math.abs(start.to_s - at_s) < near) return { kind: 'to', index, start };
    }
    for (const index of order) {
      const start = all[index] as Part;
      if (at_s > start.from_s && at_s < start.to_s) return { kind: 'whole', index, start };
    }
    return { kind: 'new' };
  };
  /** `now`: where the part that is dragged stands by now, -1 before its first move. */
  const dragged = (held: Grip, from_s: number, at_s: number, now: number): [Part[], number] => {
    if (held.kind === 'new') {
      const left = Math.min(from_s, at_s), part = emptyPart(left, Math.max(from_s, at_s, left + kLeast_s));
      return now < 0 ? [[...parts(), part], parts().length] : [parts().map((each, n) => (n === now ? part : each)), now];
    }
    const { start } = held, index = now < 0 ? held.index : now, length = start.to_s - start.from_s;
    const left = Math.max(0, Math.min(length_s - length, start.from_s + at_s - from_s));
    const part = held.kind === 'from' ? { ...start, from_s: Math.min(at_s, start.to_s - kLeast_s) }
      : held.kind === 'to' ? { ...start, to_s: Math.max(at_s, start.from_s + kLeast_s) } : { ...start, from_s: left, to_s: left + length };
    return [parts().map((each, n) => (n === index ? part : each)), index];
  };
  for (const surface of [picture.wave, picture.sonagram]) {
    const { canvas } = surface;
    let held: { grip: Grip; x: number; from_s: number; moving: boolean; added: number } | null = null;
    canvas.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      const from_s = picture.timeAt(event.offsetX);
      held = { grip: grip(from_s), x: event.offsetX, from_s, moving: false, added: -1 };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      const at_s = picture.timeAt(event.offsetX);
      if (!held) {
        const { kind } = grip(at_s);
        canvas.dataset.grip = kind;
        return;
      }
      if (!held.moving && Math.abs(event.offsetX - held.x) < kDrag_px) return;
      const merge = held.moving;
      held.moving = true;
      const [changed, selected] = dragged(held.grip, held.from_s, at_s, held.added);
      held.added = to.change(changed, selected, merge);
    });
    const end = (event: PointerEvent): void => {
      if (held && !held.moving) {
        to.setCursor(picture.timeAt(event.offsetX));
        to.select(held.grip.kind === 'new' ? -1 : held.grip.index);
      }
      held = null;
    };
    canvas.addEventListener('pointerup', end);
    canvas.addEventListener('pointercancel', () => { held = null; });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) to.pan(picture.width_s(event.deltaX || event.deltaY));
      else to.zoom(1.0018 ** event.deltaY, picture.timeAt(event.offsetX));
    }, { passive: false });
  }
};
