#include "chain/blind_start.hpp"

#include <algorithm>
#include <utility>

#include "denoise/beyond_chance.hpp"
#include "denoise/initial_nmf.hpp"
#include "rigsound/analysis/rate.hpp"
#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {
namespace {

constexpr unsigned kStarts = 3;
// Lower, a diesel's orders are louder than any drill; higher, an octave has samples enough to be heard beyond
// chance.
constexpr double kLowestOctave_hz = 250, kHighestOctave_hz = 707.2, kOctaveStep = 1.4142135623730951;
constexpr double kLeastOfOctave = 0.5;  // clearness: noise of an octave has 0.3 to 0.4, seldom 0.5
constexpr double kOctaveAhead = 0.25;   // of a split, whose bands all agree on its chain
constexpr double kOutside = 0.003;  // of all power there: a whitener has no use for a band that ends sharply

BlindStart start_from(unsigned seed, const std::vector<float>& x, const WordFit& clip) {
  InitialNmfOptions initial;
  initial.seed = seed;
  BlindStart start;
  start.blind = initial_nmf(clip, initial);
  start.found = search_clicks(x, mean_psd(start.blind, clip.power()));
  return start;
}

void search_beyond_chance(const std::vector<float>& x, const WordFit& clip, const Grid& background,
                          BlindStart& start) {
  ClickSearch other = search_clicks(x, psd_beyond_chance(start.blind, clip.power(), background));
  if (other.clearness() > start.found.clearness()) start.found = std::move(other);
}

/// All of `total` (mean power per bin) from `low_hz` an octave up is drilling, hardly any of the rest.
MeanPsd psd_of_octave(double low_hz, const Eigen::ArrayXd& total) {
  MeanPsd octave{kOutside * total, (1 - kOutside) * total};
  const double bin_hz = 0.5 * kAnalysisRate / static_cast<double>(total.size() - 1);
  const long first = static_cast<long>(low_hz / bin_hz), last = static_cast<long>(2 * low_hz / bin_hz) + 1;
  octave.S.segment(first, last - first + 1) = total.segment(first, last - first + 1);
  octave.N.segment(first, last - first + 1) = 0;
  return octave;
}

/// The clearest chain of an octave, where one is clear enough to tell a drill that the split does not.
void search_octaves(const std::vector<float>& x, const PowerSpectrogram& power, BlindStart& start) {
  const Eigen::ArrayXd total = mean_power(power);
  double least = std::max(kLeastOfOctave, start.found.clearness() + kOctaveAhead);
  for (double low_hz = kLowestOctave_hz; low_hz < kHighestOctave_hz; low_hz *= kOctaveStep) {
    ClickSearch found = search_clicks(x, psd_of_octave(low_hz, total));
    if (found.clearness() <= least) continue;
    least = found.clearness();
    start.found = std::move(found);
  }
}

}  // namespace

BlindStart clearest_start(const ChainOptions& options, const std::vector<float>& x, const WordFit& clip,
                          const Grid& background) {
  BlindStart best = start_from(options.seed, x, clip);
  if (best.found.clearness() >= kClear) return best;
  search_beyond_chance(x, clip, background, best);
  for (unsigned more = 1; more < kStarts; ++more) {
    if (!options.labelled && best.found.clearness() < kHopeless) break;
    BlindStart other = start_from(options.seed + more, x, clip);
    search_beyond_chance(x, clip, background, other);
    if (other.found.clearness() > best.found.clearness()) best = std::move(other);
  }
  search_octaves(x, clip.power(), best);
  return best;
}

}  // namespace rigsound::analysis
