#include "chain/blind_start.hpp"

#include <algorithm>
#include <optional>
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

/// `ahead`: by more than this.
void keep_clearer(ClickSearch other, double ahead, BlindStart& start) {
  if (other.clearness() > start.found.clearness() + ahead) start.found = std::move(other);
}

void search_beyond_chance(const std::vector<float>& x, const WordFit& clip, const Grid& background,
                          BlindStart& start) {
  keep_clearer(search_clicks(x, psd_beyond_chance(start.blind, clip.power(), background)), 0, start);
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

/// The clearest chain of an octave, if one is clear enough to tell a drill.
std::optional<ClickSearch> found_in_octave(const std::vector<float>& x, const PowerSpectrogram& power) {
  const Eigen::ArrayXd total = power.P.leftCols(power.frames).cast<double>().rowwise().mean();
  std::optional<ClickSearch> clearest;
  for (double low_hz = kLowestOctave_hz; low_hz < kHighestOctave_hz; low_hz *= kOctaveStep) {
    ClickSearch found = search_clicks(x, psd_of_octave(low_hz, total));
    if (found.clearness() >= std::max(kLeastOfOctave, clearest ? clearest->clearness() : 0))
      clearest = std::move(found);
  }
  return clearest;
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
  if (auto octave = found_in_octave(x, clip.power())) keep_clearer(std::move(*octave), kOctaveAhead, best);
  return best;
}

}  // namespace rigsound::analysis
