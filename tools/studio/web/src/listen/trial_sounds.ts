// The sounds of one trial, their levels matched, side by side.
import { fileContext, loadSound } from '../audio/sound_files';
import { SwitchingPlayer } from '../audio/switching_player';
import { askJson } from '../server/request';

export type Kind = 'recorded' | 'denoised' | 'synthesised' | 'anchor';
const kSeconds = 5;

export const trialPlayer = async (bank: string, kinds: readonly Kind[]): Promise<SwitchingPlayer> => {
  const [context, levels, ...buffers] = await Promise.all([fileContext(),
    askJson<{ gain_db: Record<Kind, number> }>('/listen/sounds', { method: 'POST', body: { bank, from_s: 0, seconds: kSeconds } }),
    ...kinds.map((kind) => loadSound(`/banks/${bank}/sound/${kind}`))]);
  const player = new SwitchingPlayer(context);
  kinds.forEach((kind, n) => player.put(kind, buffers[n] as AudioBuffer, 10 ** ((levels.gain_db[kind] ?? 0) / 20)));
  player.loop = { from_s: 0, to_s: Math.min(kSeconds, player.length_s) };
  return player;
};
