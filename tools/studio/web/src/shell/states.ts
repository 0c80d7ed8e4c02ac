// What stands in a page's place while there is nothing to work with: loading, empty, wrong.
import { h, type Child } from '../dom/element';
import { button } from '../dom/fields';

export const loading = (words: string): HTMLElement =>
  h('div', { class: 'state', role: 'status' }, h('div', { class: 'busy' }), h('p', {}, words));

export const empty = (title: string, ...children: Child[]): HTMLElement =>
  h('div', { class: 'state' }, h('h2', {}, title), ...children);

export const failed = (error: unknown, again?: () => void): HTMLElement =>
  h('div', { class: 'state error', role: 'alert' }, h('h2', {}, 'That did not work'),
    h('p', {}, error instanceof Error ? error.message : String(error)), again ? button('Try again', again) : null);
