// Sounds and tiles for the fake server: what the real one would send of a recording, made from formulas.
import { deflateSync } from 'node:zlib';

/** A 32-bit float WAV of one channel. */
export const wav = (samples, rate = 48000) => {
  const data = Buffer.from(Float32Array.from(samples).buffer), head = Buffer.alloc(44);
  head.write('RIFF', 0); head.writeUInt32LE(36 + data.length, 4); head.write('WAVEfmt ', 8); head.writeUInt32LE(16, 16);
  head.writeUInt16LE(3, 20); head.writeUInt16LE(1, 22); head.writeUInt32LE(rate, 24); head.writeUInt32LE(4 * rate, 28);
  head.writeUInt16LE(4, 32); head.writeUInt16LE(32, 34); head.write('data', 36); head.writeUInt32LE(data.length, 40);
  return Buffer.concat([head, data]);
};

export const constant = (value, seconds) => wav(new Float32Array(Math.round(seconds * 48000)).fill(value));
export const tone = (hz, seconds, level = 0.2) => wav(Float32Array.from({ length: Math.round(seconds * 48000) }, (_, n) => level * Math.sin(2 * Math.PI * hz * n / 48000)));

const kCrcs = Uint32Array.from({ length: 256 }, (_, n) => { for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1; return n >>> 0; });
const chunk = (name, data) => {
  const text = Buffer.concat([Buffer.from(name), data]);
  let crc = 0xffffffff;
  for (const octet of text) crc = kCrcs[(crc ^ octet) & 255] ^ (crc >>> 8);
  const length = Buffer.alloc(4), sum = Buffer.alloc(4);
  length.writeUInt32BE(data.length); sum.writeUInt32BE((crc ^ 0xffffffff) >>> 0);
  return Buffer.concat([length, text, sum]);
};
/** A grey picture of 1024 x 256, `value(x, y)` 0...255. */
export const picture = (value) => {
  const head = Buffer.alloc(13), rows = Buffer.alloc(1025 * 256);
  head.writeUInt32BE(1024, 0); head.writeUInt32BE(256, 4); head[8] = 8; head[9] = 0;
  for (let y = 0; y < 256; ++y) for (let x = 0; x < 1024; ++x) rows[1025 * y + 1 + x] = value(x, y);
  return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk('IHDR', head), chunk('IDAT', deflateSync(rows)), chunk('IEND', Buffer.alloc(0))]);
};

/** Least and most of 1024 columns of a recording that is quiet, drills from 4 s to 9 s, and is quiet again. */
export const peaks = (level, tile, rate = 48000) => {
  const out = new Int8Array(2048), column_s = 64 * 2 ** level / rate;
  for (let n = 0; n < 1024; ++n) {
    const at = (tile * 1024 + n) * column_s, height = at > 20 ? 0 : at > 4 && at < 9 ? 70 + 20 * Math.sin(40 * at) : 8;
    out[2 * n] = -height; out[2 * n + 1] = height;
  }
  return Buffer.from(out.buffer);
};
