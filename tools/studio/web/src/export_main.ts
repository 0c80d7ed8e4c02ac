// The Rig page as one file: engine, processor and packed sound set lie in it, deflated, as text.
import { h } from './dom/element';
import { button } from './dom/fields';
import { openRigView } from './rig/rig_view';
import type { Rig } from './server/documents';
import { fromPlanes, inflated } from './server/page_text';
import { Shortcuts } from './shell/shortcuts';
import { failed, loading } from './shell/states';

const textOf = (id: string): string => document.getElementById(id)?.textContent ?? '';

const start = async (): Promise<void> => {
  const tools = h('div', { class: 'tools' }), place = h('div', { class: 'stack' }, loading('Opening'));
  const keys = new Shortcuts([]), texts = ['engine', 'sound-set'].map(textOf);
  // A page from file:// has an origin of its own that no blob's address belongs to.
  const worklet = `data:text/javascript;base64,${textOf('worklet')}`, rig = textOf('rig');
  document.body.replaceChildren(h('main', {}, h('header', {}, h('h1', {}, 'Rig'), h('p', {}, 'The sound set as the cabin plays it'), tools,
    button('Keys', () => keys.show(), { 'aria-keyshortcuts': '?' })), place));
  try {
    const [engine, planes] = await Promise.all(texts.map(inflated)) as [Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>], set = fromPlanes(planes);
    const view = await openRigView(place, tools, { parts: { module: await WebAssembly.compile(engine), worklet }, set,
      rig: JSON.parse(rig) as Rig, logs: [], timelineOf: () => Promise.reject(new Error('no logs here')) });
    keys.ofPage(view.shortcuts);
  } catch (error) {
    place.replaceChildren(failed(error));
  }
};
void start();
