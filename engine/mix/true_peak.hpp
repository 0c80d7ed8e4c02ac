// Peaks between samples, as the loudness meters see them.
#pragma once

#include "rigsound/dsp/lanes.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::mix {

/// Taps of the four-times oversampling filter of ITU-R BS.1770-4, annex 2: phases 0 and 1 of four, newest
/// sample first; phase 2 is phase 1 backwards, phase 3 phase 0.
constexpr int kTruePeakTaps = 12;
constexpr double kTruePeakPhase[2][kTruePeakTaps] = {
    {0.0017089843750, 0.0109863281250, -0.0196533203125, 0.0332031250000, -0.0594482421875, 0.1373291015625,
     0.9721679687500, -0.1022949218750, 0.0476074218750, -0.0266113281250, 0.0148925781250, -0.0083007812500},
    {-0.0291748046875, 0.0292968750000, -0.0517578125000, 0.0891113281250, -0.1665039062500, 0.4650878906250,
     0.7797851562500, -0.2003173828125, 0.1015625000000, -0.0582275390625, 0.0330810546875,
     -0.0189208984375}};

/// No true peak is higher than this many times the highest sample it is made of: the sum of |taps| of
/// phase 1.
constexpr double kTruePeakSpread = 2.0228271484375;

/// The highest of the samples and true peaks of a chunk of two channels, found only as far as they could pass
/// a level that is of interest: most chunks cost one look at each sample.
class TruePeak {
 public:
  static constexpr int kPast = 16;  ///< frames of the chunks before that it looks at

  /// `x`: kChunk frames, the kPast frames before them in front of it. What is below `least` may come out as
  /// less than it is. Thread: RT.
  double of(const dsp::Lanes* x, double least) noexcept;

 private:
  double past_[2] = {};  ///< highest samples of the kPast frames before, eight each
};

}  // namespace rigsound::mix
