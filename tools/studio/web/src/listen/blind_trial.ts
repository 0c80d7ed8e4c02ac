// A trial whose sounds only the server can tell apart before it is over.
import { fileContext, loadSound } from '../audio/sound_files';
import { SwitchingPlayer } from '../audio/switching_player';
import { askJson } from '../server/request';

export type Kind = 'recorded' | 'denoised' | 'synthesised' | 'anchor';

export interface TrialWish { test: 'abx' | 'rating'; bank: string; pair?: readonly [Kind, Kind] }

export interface BlindTrial {
  id: string;
  bank: string;
  /** Where its sounds are heard: a, b, x, or reference, 1, 2, 3, 4. */
  places: string[];
  player: SwitchingPlayer;
}

export const openTrial = async (wish: TrialWish): Promise<BlindTrial> => {
  const { id, seconds, sounds } = await askJson<{ id: string; seconds: number; sounds: string[] }>('/listen/trials', { method: 'POST', body: wish });
  const [context, ...buffers] = await Promise.all([fileContext(), ...sounds.map((place) => loadSound(`/listen/trials/${id}/sounds/${place}`))]);
  const player = new SwitchingPlayer(context);
  sounds.forEach((place, n) => player.put(place, buffers[n] as AudioBuffer));
  player.loop = { from_s: 0, to_s: seconds };
  return { id, bank: wish.bank, places: sounds, player };
};

/** Ends a trial; what was heard at each of its places. */
export const endTrial = async (id: string): Promise<Record<string, Kind>> =>
  (await askJson<{ sounds: Record<string, Kind> }>(`/listen/trials/${id}`, { method: 'DELETE' })).sounds;
