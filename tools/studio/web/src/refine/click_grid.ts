// The clicks of a bank: each can be heard alone, and dropped.
import { h } from '../dom/element';

export const clickGrid = (indices: number[], hear: (index: number) => void, drop: (index: number, dropped: boolean) => void) => {
  const cells = indices.map((index) => {
    const keep = h('input', { type: 'checkbox', id: `click-${index}` });
    keep.addEventListener('change', () => drop(index, !keep.checked));
    const listen = h('button', { type: 'button', 'aria-label': `Hear click ${index + 1}` }, 'Hear');
    listen.addEventListener('click', () => hear(index));
    return { index, keep, element: h('div', { class: 'click row' }, keep, h('label', { for: `click-${index}`, class: 'grow' }, `Click ${index + 1}`), listen) };
  });
  return {
    element: h('div', { class: 'clicks' }, ...cells.map(({ element }) => element)),
    /** Two clicks at least must stay. */
    show: (dropped: number[]) => cells.forEach(({ index, keep }) => {
      keep.checked = !dropped.includes(index);
      keep.disabled = keep.checked && indices.length - dropped.length <= 2;
    }),
  };
};
