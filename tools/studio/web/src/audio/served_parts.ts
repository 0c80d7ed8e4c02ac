// Engine and processor as the studio's server gives them; compiled once.
import type { Parts } from './rig_player';

let parts: Promise<Parts> | null = null;

export const servedParts = (): Promise<Parts> => {
  parts ??= (async () => ({ module: await WebAssembly.compileStreaming(fetch('engine.wasm')), worklet: 'worklet.js' }))();
  parts.catch(() => { parts = null; });
  return parts;
};
