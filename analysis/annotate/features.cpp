#include "annotate/features.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/quantile.hpp"
#include "spectrum/window_power.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kLowestBand_hz = 88, kFloor = 1e-12;
constexpr int kWindowsOfFrame = 4;         // each of about 21 ms
constexpr double kEnvelopeRate_hz = 1024;  // nominal; an envelope sample is a whole number of frames
constexpr int kEnvelopeWindow = 1024;      // kRateWindow_s of it
constexpr double kSlowest_hz = 8, kFastest_hz = 100, kRateStep = 1.005;
constexpr double kSteady =
    12;  // score of a rhythm over the median score of all rates, from which on it counts

/// Mean power of each band over one frame.
class FrameLevels {
 public:
  explicit FrameLevels(int rate) : rate_(rate), spectrum_(short_window(rate)) {}

  int window() const { return spectrum_.length(); }

  /// `x`: a frame and half a window on either side of it.
  Eigen::ArrayXd of(const float* x, std::size_t frame) {
    spectrum_.clear();
    for (int w = 0; w < kWindowsOfFrame; ++w)
      spectrum_.add(x + frame * static_cast<std::size_t>(2 * w + 1) / (2 * kWindowsOfFrame),
                    1.0 / kWindowsOfFrame);
    Eigen::ArrayXd levels(kFeatureBands);
    double low = kLowestBand_hz;
    for (int b = 0; b < kFeatureBands; ++b, low *= 2)
      levels[b] = 10 * std::log10(band(low, 2 * low) + kFloor);
    return levels;
  }

 private:
  double band(double low_hz, double high_hz) const {
    const double bin = static_cast<double>(rate_) / spectrum_.length();
    const auto last = static_cast<double>(spectrum_.power().size() - 1);
    if (low_hz / bin >= last) return 0;
    double sum = 0;
    for (auto k = static_cast<std::size_t>(low_hz / bin);
         k <= static_cast<std::size_t>(std::min(high_hz / bin, last)); ++k)
      sum += spectrum_.power()[k];
    return sum;
  }

  int rate_;
  WindowPower spectrum_;
};

/// Rate of the strongest rhythm in a stretch of the envelope: the rate whose first four harmonics of
/// modulation are strongest together.
class RateFinder {
 public:
  explicit RateFinder(double envelope_rate)
      : spectrum_(kEnvelopeWindow), bin_(envelope_rate / kEnvelopeWindow) {
    for (double hz = kSlowest_hz; hz < kFastest_hz; hz *= kRateStep) rates_.push_back(hz);
  }

  /// `x`: kEnvelopeWindow samples. 0: no steady rhythm.
  double rate_of(std::vector<float> x) {
    double mean = 0;
    for (const float v : x) mean += static_cast<double>(v) / static_cast<double>(x.size());
    for (float& v : x) v -= static_cast<float>(mean);
    spectrum_.clear();
    spectrum_.add(x.data(), 1);
    std::vector<double> scores;
    for (const double hz : rates_) scores.push_back(score(hz));
    const auto best = std::max_element(scores.begin(), scores.end());
    return *best > kSteady * upper_median(scores) ? rates_[static_cast<std::size_t>(best - scores.begin())]
                                                  : 0;
  }

 private:
  double score(double hz) const {
    constexpr int kHarmonics = 4;
    double sum = 0;
    for (int k = 1; k <= kHarmonics; ++k) {
      const double place = k * hz / bin_;
      const auto below = static_cast<std::size_t>(place);
      if (below + 1 >= spectrum_.power().size()) break;
      const double share = place - static_cast<double>(below);
      sum += ((1 - share) * spectrum_.power()[below] + share * spectrum_.power()[below + 1]) / k;
    }
    return sum;
  }

  WindowPower spectrum_;
  double bin_;
  std::vector<double> rates_;
};

/// Square root of the energy of each stretch of `wide` samples, of the sound's slope: impacts stand out of
/// the diesel.
void add_envelope(const float* x, std::size_t count, std::size_t wide, std::vector<float>& envelope) {
  for (std::size_t at = 0; at + wide <= count; at += wide) {
    double energy = 0;
    for (std::size_t n = at; n < at + wide; ++n) {
      const double slope = static_cast<double>(x[n + 1]) - static_cast<double>(x[n]);
      energy += slope * slope;
    }
    envelope.push_back(static_cast<float>(std::sqrt(energy)));
  }
}

}  // namespace

Features features_of(SoundReader& sound, const Progress& progress) {
  const int rate = sound.shape().rate;
  const auto wide = static_cast<std::size_t>(std::lround(rate / kEnvelopeRate_hz));
  const std::size_t steps =
      static_cast<std::size_t>(std::lround(kFeatureHop_s * rate / static_cast<double>(wide)));
  const std::size_t hop = wide * steps;  // of a frame, samples
  const long frames = std::max(1L, sound.shape().frames / static_cast<long>(hop));
  FrameLevels bands(rate);
  const long margin = bands.window() / 2;
  std::vector<float> x(hop + static_cast<std::size_t>(2 * margin) + 1), envelope;
  Features features;
  features.hop_s = static_cast<double>(hop) / rate;
  features.levels.resize(kFeatureBands, frames);
  for (long f = 0; f < frames; ++f) {
    sound.read(f * static_cast<long>(hop) - margin, x.size(), x.data());
    features.levels.col(f) = bands.of(x.data(), hop);
    add_envelope(x.data() + margin, hop, wide, envelope);
    if (progress && f % 16 == 0) progress(0.8 * static_cast<double>(f) / static_cast<double>(frames));
  }
  RateFinder finder(static_cast<double>(rate) / static_cast<double>(wide));
  for (long f = 0; f < frames; ++f) {
    const long middle = f * static_cast<long>(steps) + static_cast<long>(steps) / 2;
    std::vector<float> stretch(kEnvelopeWindow, 0.0F);
    for (long n = 0; n < kEnvelopeWindow; ++n) {
      const long at = middle - kEnvelopeWindow / 2 + n;
      if (at >= 0 && at < static_cast<long>(envelope.size()))
        stretch[n] = envelope[static_cast<std::size_t>(at)];
    }
    features.rate_hz.push_back(finder.rate_of(std::move(stretch)));
    if (progress && f % 16 == 0) progress(0.8 + 0.15 * static_cast<double>(f) / static_cast<double>(frames));
  }
  return features;
}

}  // namespace rigsound::analysis
