// Sound files of the server as buffers of the page's context.
import { ask } from '../server/request';
import { outputAt } from './output';

export const kFileRate_hz = 48000;

export const fileContext = (): Promise<AudioContext> => outputAt(kFileRate_hz);

export const loadSound = async (path: string, options: { method?: string; body?: unknown; signal?: AbortSignal } = {}): Promise<AudioBuffer> => {
  const [context, response] = await Promise.all([fileContext(), ask(path, options)]);
  return context.decodeAudioData(await response.arrayBuffer());
};
