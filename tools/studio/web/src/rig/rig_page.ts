// Rig: the whole rig from the sound set, by hand or along a bus log.
import { servedParts } from '../audio/served_parts';
import { noBanks } from '../bank/bank_list';
import type { Rig, SoundSet, Timeline } from '../server/documents';
import { askBytes, askJson } from '../server/request';
import type { Page } from '../shell/page';
import { openRigView } from './rig_view';

export const rigPage: Page = {
  id: 'rig', title: 'Rig', about: 'The sound set as the cabin plays it',
  open: async (place, tools, state) => {
    const sounds = await askJson<SoundSet>('/sound_set');
    if (sounds.banks.length === 0) {
      place.replaceChildren(noBanks());
      return { close: () => undefined };
    }
    const [parts, set, rig] = await Promise.all([servedParts(), askBytes('/sound_set.rigset?rig=1'), askJson<Rig>('/rig')]);
    return openRigView(place, tools, { parts, set, rig, logs: state.logs,
      timelineOf: (id) => askJson<Timeline>(`/logs/${id}/timeline`) });
  },
};
