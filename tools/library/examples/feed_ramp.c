/* feed_ramp RIG.toml OUT.wav: ten seconds of drilling while the feed rises from 40 to 190 bar.
 *
 *   cc -std=c99 feed_ramp.c $(pkg-config --cflags --libs rigsound) -o feed_ramp
 *
 * Writes a WAV of 32 bit float by hand, so that it needs nothing but rigsound. */
#include <rigsound.h>
#include <stdio.h>
#include <stdlib.h>

static void put_u32(FILE* file, uint32_t value) {
  int shift;
  for (shift = 0; shift < 32; shift += 8) fputc((int)(value >> shift & 0xff), file);
}

static void put_u16(FILE* file, unsigned value) {
  fputc((int)(value & 0xff), file);
  fputc((int)(value >> 8), file);
}

static void put_header(FILE* file, unsigned channels, uint32_t rate, uint32_t data_bytes) {
  fputs("RIFF", file), put_u32(file, 36 + data_bytes), fputs("WAVEfmt ", file), put_u32(file, 16);
  put_u16(file, 3), put_u16(file, channels), put_u32(file, rate), put_u32(file, rate * channels * 4);
  put_u16(file, channels * 4), put_u16(file, 32), fputs("data", file), put_u32(file, data_bytes);
}

static int fail(const char* what) {
  fprintf(stderr, "%s\n", what);
  return 1;
}

int main(int count, char** arguments) {
  rigsound_handle* rig;
  FILE* file;
  float* block;
  size_t samples, n;
  long blocks, i;
  if (count != 3) return fail("usage: feed_ramp RIG.toml OUT.wav");
  rig = rigsound_open(arguments[1]);
  if (rig == NULL) return fail(rigsound_last_error(NULL));
  file = fopen(arguments[2], "wb");
  if (file == NULL) return perror(arguments[2]), 1;

  samples = (size_t)(rigsound_block(rig) * rigsound_channels(rig));
  block = malloc(samples * sizeof *block);
  if (block == NULL) return fail("no memory");
  blocks = (long)(10 * rigsound_rate(rig) / rigsound_block(rig));
  put_header(file, (unsigned)rigsound_channels(rig), (uint32_t)rigsound_rate(rig),
             (uint32_t)((size_t)blocks * samples * 4));

  rigsound_set(rig, "engine_rpm", 0, 1500);
  for (i = 0; i < blocks; ++i) {
    /* One bar a step, fifteen steps a second. */
    const double second = (double)i * rigsound_block(rig) / rigsound_rate(rig);
    if (rigsound_set(rig, "feed_pressure_bar", 0, 40 + (long)(15 * second)) != RIGSOUND_OK)
      return fail(rigsound_last_error(rig));
    rigsound_process(rig, block);
    for (n = 0; n < samples; ++n) {
      union {
        float sample;
        uint32_t bits;
      } out;
      out.sample = block[n];
      put_u32(file, out.bits);
    }
  }
  free(block);
  rigsound_close(rig);
  if (fclose(file) != 0) return perror(arguments[2]), 1;
  return 0;
}
