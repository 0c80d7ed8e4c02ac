// The ceiling, kept between samples too: a limiter that knows what comes.
#pragma once

#include <vector>

#include "mix/gain_curve.hpp"
#include "mix/true_peak.hpp"
#include "rigsound/dsp/lanes.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::mix {

/// Both channels share one gain, so the image stays where it is. Each chunk wishes for a gain that brings its
/// true peaks to the target; the lowest wish holds for a while, then the gain recovers exponentially. The
/// gain follows these points, one a chunk, along a quadratic B-spline: no step, no corner.
///
/// Why no true peak passes the ceiling. Under all twelve samples of a true peak P = |sum h_k x_k| the gain is
/// at most target / P: were it the same for all, the target would hold. It is not, by the first two terms of
/// its Taylor series about the filter's middle. Where it has begun to fall by D, and has D t^2 / 2 behind it,
/// it falls by D t / kChunk a sample and bends by D / kChunk^2. With A = sum |h_k| |k| = 2.4 and B = sum
/// |h_k| k^2 = 6.7, and no sample over the target either, that adds at most A t / kChunk - t^2 / 2 + B / (2
/// kChunk^2) <= 0.61 % of the target, for any t; anywhere else, as on the way up, it adds less than the gain
/// is lower than it had to be. The target leaves 0.8 %.
class LookaheadLimiter {
 public:
  /// `ceiling`: linear, > 0; `chunks` >= kLeastLookahead. Thread: OFF.
  LookaheadLimiter(double ceiling, int chunks, double sample_rate);

  /// Where the next chunk is to be written. Thread: RT.
  dsp::Lanes* input() noexcept { return slot(newest_) + TruePeak::kPast; }

  /// Takes the chunk at input(), nothing but zeros unless it `sounds`. Returns the one that came `chunks`
  /// earlier, on which gain() is to be applied now; null: it is all zeros. It stays until the next is
  /// written. Thread: RT.
  const dsp::Lanes* process(bool sounds) noexcept;

  const GainCurve& gain() const noexcept { return gain_; }

 private:
  /// A chunk behind the kPast frames before it; vectors of any width lie within a line of the cache.
  struct alignas(64) Slot {
    dsp::Lanes x[TruePeak::kPast + kChunk] = {};
  };

  dsp::Lanes* slot(int chunk) noexcept { return line_[static_cast<std::size_t>(chunk)].x; }
  int before(int chunk) const noexcept { return chunk == 0 ? chunks_ : chunk - 1; }
  double wish(bool sounds) noexcept;
  double lowest_wish() const noexcept;
  void move_gain(double wish) noexcept;

  double target_, release_;
  int chunks_;
  std::vector<Slot> line_;    ///< chunks_ + 1 chunks in turn
  std::vector<char> sounds_;  ///< of each
  int newest_ = 0;
  TruePeak peak_;

  std::vector<double> wishes_;              ///< of the last chunks, in turn
  std::size_t next_wish_ = 0, wished_ = 0;  ///< wished_: chunks until the last wish under 1 is forgotten
  std::vector<double> held_;  ///< the gain wished, held and recovering, of the last chunks, in turn
  std::size_t next_held_ = 0;
  double recovered_ = 1;                      ///< the newest of held_
  double before_ = 1, here_ = 1, after_ = 1;  ///< points of the curve
  GainCurve gain_;
};

}  // namespace rigsound::mix
