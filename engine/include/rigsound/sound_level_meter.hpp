// How loud the output is for an ear: A- and C-weighted levels (IEC 61672-1).
#pragma once

#include "rigsound/dsp/biquad.hpp"
#include "rigsound/machine/fields.hpp"

namespace rigsound {

struct CalibrationOptions {
  /// Sound pressure level at the ear while one channel plays a sine of 1 kHz and amplitude 1 (0 dBFS after
  /// AES17); channels add up in power. 0: not calibrated.
  double db_spl_at_0dbfs = 0;
};

template <class Archive>
void fields(Archive& a, CalibrationOptions& o) {
  a("db_spl_at_0dbfs", o.db_spl_at_0dbfs, Range{60, 160, "dB"}.or_zero());
}

/// Plain data. Powers: 1 is that of a sine of amplitude 1 on one channel.
struct SoundLevel {
  double fast = 0, slow = 0;  ///< A-weighted, exponential averages over 125 ms and 1 s, at the block's end
  double mean = 0;            ///< A-weighted, of the block
  double c_peak = 0;          ///< C-weighted, of the block: highest |sum of the channels|, an amplitude
};

class SoundLevelMeter {
 public:
  /// Hears the first two of `channels`, which are those that sound, or the only one. Thread: OFF.
  SoundLevelMeter(double sample_rate, int channels);

  /// A block of `frames`, a multiple of kChunk, interleaved. Costs next to nothing in silence. Thread: RT.
  void process(const float* x, int frames) noexcept;

  const SoundLevel& level() const noexcept { return level_; }  ///< Thread: RT

 private:
  double chunk(const float* x) noexcept;
  bool rests(const float* x) const noexcept;

  int channels_;
  double fast_, slow_;  ///< shares of an average that are left after a chunk
  dsp::BiquadPair c_[2], a_;
  SoundLevel level_;
};

}  // namespace rigsound
