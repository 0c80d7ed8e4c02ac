// What a page plays of a table of states, and what `rigsound render` makes of it, as digests of the samples.
import { createHash } from 'node:crypto';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { rigsound } from './places.mjs';
import { run } from './small_set.mjs';

const kStates = [[0, 'engine_rpm', 1500], [0.5, 'feed_pressure_bar', 40], [1.5, 'feed_pressure_bar', 90.25], [2, 'rod_count', 3],
  [3.0004, 'feed_pressure_bar', 170], [4, 'percussion_pressure_bar', 120], [5, 'feed_pressure_bar', 0], [5.5, 'rattling', 2],
  [7, 'rattling', 0], [7, 'engine_load', 0.4], [8, 'master_gain_db', -6], [9, 'feed_pressure_bar', 100]];
const kSeconds = 10, kRate = 48000, kBlock = 64;

export const renderedDigest = (set) => {
  const blocks = Math.round(kSeconds * kRate / kBlock), last = (blocks - 1) * kBlock / kRate;
  writeFileSync(join(set.folder, 'states.csv'), 'time_s,signal,value\n' +
    [...kStates, [last.toFixed(6), 'feed_pressure_bar', 100]].map((row) => row.join(',')).join('\n') + '\n');
  return run(rigsound, 'render', set.rig, '--states', join(set.folder, 'states.csv'), '--out', join(set.folder, 'out.wav')).split('\n')[0].replace('sha256 ', '');
};

/** `parts`: a handle in the page of {worklet, module, set}, the processor's address, the engine and the octets of the packed set. */
export const playedDigest = async (parts) => {
  const played = await parts.evaluate(async ({ worklet, module, set }, { states, seconds, rate }) => {
    const context = new OfflineAudioContext(2, seconds * rate, rate);
    await context.audioWorklet.addModule(worklet);
    const changes = states.map(([time, name, value]) => ({ frame: time * rate, call: 'set', name, boom: 0, value }));
    new AudioWorkletNode(context, 'rigsound', { numberOfInputs: 0, outputChannelCount: [2], processorOptions: { module, set, changes } }).connect(context.destination);
    const buffer = await context.startRendering(), samples = new Float32Array(2 * buffer.length);
    for (let channel = 0; channel < 2; ++channel) buffer.getChannelData(channel).forEach((v, n) => { samples[2 * n + channel] = v; });
    let text = '';
    const octets = new Uint8Array(samples.buffer);
    for (let n = 0; n < octets.length; n += 32768) text += String.fromCharCode(...octets.subarray(n, n + 32768));
    return btoa(text);
  }, { states: kStates, seconds: kSeconds, rate: kRate });
  return createHash('sha256').update(Buffer.from(played, 'base64')).digest('hex');
};
