// Sound files of the server as buffers of the page's context.
import { ask, type Ask } from '../server/request';
import { outputAt } from './output';

export const kFileRate_hz = 48000;

export const fileContext = (): Promise<AudioContext> => outputAt(kFileRate_hz);

/** At the rate of `context`, whatever that of the file. */
export const soundFor = async (context: BaseAudioContext, path: string, options: Ask = {}): Promise<AudioBuffer> =>
  context.decodeAudioData(await (await ask(path, options)).arrayBuffer());

export const loadSound = async (path: string, options: Ask = {}): Promise<AudioBuffer> => soundFor(await fileContext(), path, options);
