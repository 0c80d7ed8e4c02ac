// Bytes that lie in a page as text (tools/studio/server/page_text.hpp).

const kNeverInScripts = [0x00, 0x0d, 0x3c];

const octetsOf = (text: string): Uint8Array<ArrayBuffer> => {
  const octets = new Uint8Array(2 * text.length);
  let held = 0, bits = 0, count = 0;
  const take = (seven: number): void => {
    held = (held << 7 | seven) & 0x3fff;
    bits += 7;
    if (bits < 8) return;
    bits -= 8;
    octets[count++] = held >> bits;
  };
  for (let i = 0; i < text.length; ++i) {
    const letter = text.charCodeAt(i), which = (letter - 0x100) >> 7;
    if (letter < 0x100) { take(letter); continue; }
    take(kNeverInScripts[which % 3] as number);
    if (which < 3) take(letter & 127);
  }
  return octets.slice(0, count);
};

/** What was deflated before it became text. */
export const inflated = async (text: string): Promise<Uint8Array<ArrayBuffer>> =>
  new Uint8Array(await new Response(new Blob([octetsOf(text)]).stream().pipeThrough(new DecompressionStream('deflate'))).arrayBuffer());

/** Bytes as they were before each fourth of them was put together. */
export const fromPlanes = (planes: Uint8Array): Uint8Array<ArrayBuffer> => {
  const length = planes.length >> 2, bytes = new Uint8Array(planes);
  for (let plane = 0; plane < 4; ++plane) for (let n = 0; n < length; ++n) bytes[4 * n + plane] = planes[plane * length + n] as number;
  return bytes;
};
