// Diesel: a background's model along speed and load, its orders, and how it sounds.
import { h } from '../dom/element';
import { pick } from '../dom/fields';
import type { Rig, SoundSet } from '../server/documents';
import { askJson } from '../server/request';
import type { Page } from '../shell/page';
import { empty } from '../shell/states';
import { workFrame } from '../shell/work_frame';
import { openDiesel } from './diesel_view';

export const dieselPage: Page = {
  id: 'diesel', title: 'Diesel', about: 'The background’s model along speed and load',
  open: async (place, tools) => {
    const [sounds, rig] = await Promise.all([askJson<SoundSet>('/sound_set'), askJson<Rig>('/rig')]);
    const first = sounds.backgrounds[0];
    if (!first) {
      place.replaceChildren(empty('The sound set has no diesel yet', h('p', {}, 'rigsound background learns one from a recording of the engine along its speeds.')));
      return { close: () => undefined };
    }
    const frame = workFrame('Opening the diesel', (name, own, buttons) => openDiesel(name, rig, own, buttons), (name) => choose.set(name));
    const choose = pick('Background', sounds.backgrounds.map(({ name }) => [name, name] as const), first.name, (name) => void frame.show(name));
    tools.replaceChildren(...(sounds.backgrounds.length > 1 ? [choose.element] : []), frame.actions);
    place.replaceChildren(frame.work);
    void frame.show(first.name);
    return frame.opened;
  },
};
