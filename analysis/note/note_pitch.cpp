#include "note/note_pitch.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "diesel/angle_domain.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/fft.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr std::size_t kPitchHop = 240, kFrame = 2400, kFft = 8192;
constexpr double kLowestPitch_hz = 60, kHighestPitch_hz = 1500;
constexpr double kPeriodic = 0.85, kSteady = 0.03, kShortestPitch_s = 0.3;
constexpr double kRisen = 0.25, kAudible = 0.02;  // of the loudest energy: before is attack, below is decay
constexpr double kPhaseBand_hz = 25;  // vibrato is inside, the neighbouring harmonics are far outside

struct Frame {
  double hz = 0;  // 0: no pitch
  double energy = 0;
};

/// Normalised autocorrelation r(lag) = 2 sum x x' / sum (x^2 + x'^2); the first peak near the highest one.
Frame frame_pitch(const std::vector<double>& x, std::size_t at, const dsp::Fft<double>& fft) {
  std::vector<double> re(kFft, 0.0), im(kFft, 0.0);
  std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(at), kFrame, re.begin());
  std::vector<double> power(kFrame + 1, 0.0);
  for (std::size_t i = 0; i < kFrame; ++i) power[i + 1] = power[i] + re[i] * re[i];
  Frame frame;
  frame.energy = power[kFrame];
  fft.forward(re.data(), im.data());
  for (std::size_t i = 0; i < kFft; ++i) re[i] = re[i] * re[i] + im[i] * im[i], im[i] = 0;
  fft.inverse(re.data(), im.data());
  const auto low = static_cast<std::size_t>(kAnalysisRate / kHighestPitch_hz);
  const auto high = static_cast<std::size_t>(kAnalysisRate / kLowestPitch_hz);
  std::vector<double> r(high + 2, 0.0);
  double best = 0;
  for (std::size_t lag = low - 1; lag < r.size(); ++lag) {
    r[lag] = 2 * re[lag] / kFft / (power[kFrame - lag] + power[kFrame] - power[lag] + 1e-20);
    best = std::max(best, r[lag]);
  }
  if (best < kPeriodic) return frame;
  for (std::size_t lag = low; lag <= high; ++lag)
    if (r[lag] > 0.95 * best && r[lag] >= r[lag - 1] && r[lag] >= r[lag + 1]) {
      const double shift = 0.5 * (r[lag - 1] - r[lag + 1]) / (r[lag - 1] - 2 * r[lag] + r[lag + 1] - 1e-15);
      frame.hz = kAnalysisRate / (static_cast<double>(lag) + shift);
      return frame;
    }
  return frame;
}

double median_pitch(const std::vector<Frame>& frames, double loudest) {
  std::vector<double> hz;
  for (const Frame& f : frames)
    if (f.hz > 0 && f.energy > kAudible * loudest) hz.push_back(f.hz);
  return hz.empty() ? 0 : upper_median(std::move(hz));
}

/// Phase of harmonic h around h f0, in periods of the fundamental beyond f0 t.
std::vector<double> phase_of(const std::vector<double>& x, double f0, int h, double& level) {
  std::vector<double> re(x.size()), im(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double turns = h * f0 * static_cast<double>(n) / kAnalysisRate;
    re[n] = x[n] * std::cos(2 * M_PI * (turns - std::floor(turns)));
    im[n] = -x[n] * std::sin(2 * M_PI * (turns - std::floor(turns)));
  }
  const double band = std::min(kPhaseBand_hz, 0.3 * f0);
  re = zero_phase_low_pass(re, band, kAnalysisRate), im = zero_phase_low_pass(im, band, kAnalysisRate);
  std::vector<double> phase(x.size());
  double last = 0, whole = 0;
  level = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double turn = std::atan2(im[n], re[n]) / (2 * M_PI);
    if (n > 0) whole -= std::round(turn - last);
    last = turn;
    phase[n] = (turn + whole) / h;
    level += re[n] * re[n] + im[n] * im[n];
  }
  return phase;
}

}  // namespace

NotePitch pitch_of(const std::string& source, const std::vector<double>& x) {
  const dsp::Fft<double> fft(static_cast<int>(kFft));
  std::vector<Frame> frames;
  double loudest = 0;
  for (std::size_t at = 0; at + kFrame <= x.size(); at += kPitchHop) {
    frames.push_back(frame_pitch(x, at, fft));
    loudest = std::max(loudest, frames.back().energy);
  }
  NotePitch pitch;
  pitch.f0 = median_pitch(frames, loudest);
  std::size_t begin = 0, longest = 0;
  bool risen = false;
  for (std::size_t i = 0; i <= frames.size(); ++i) {
    risen = risen || (i < frames.size() && frames[i].energy > kRisen * loudest);
    const bool steady = i < frames.size() && risen && frames[i].energy > kAudible * loudest &&
                        std::fabs(frames[i].hz / pitch.f0 - 1) < kSteady;
    if (steady) continue;
    if (i - begin > longest)
      longest = i - begin, pitch.from = begin * kPitchHop, pitch.to = (i - 1) * kPitchHop + kFrame;
    begin = i + 1;
  }
  if (static_cast<double>(longest * kPitchHop) < kShortestPitch_s * kAnalysisRate)
    throw InputError(source, "holds no steady pitch between 60 and 1500 Hz, expected 0.3 s at least");

  std::vector<double> steady(x.begin() + static_cast<std::ptrdiff_t>(pitch.from),
                             x.begin() + static_cast<std::ptrdiff_t>(pitch.to));
  std::vector<double> phase;
  double loud = -1;
  for (int h = 1; h <= 6 && h * pitch.f0 < 5000; ++h) {
    double level = 0;
    std::vector<double> candidate = phase_of(steady, pitch.f0, h, level);
    if (level > loud) loud = level, phase.swap(candidate);
  }
  // The first and last tenth of a second lean on silence beyond; outside, the phase goes straight on.
  const std::size_t edge = std::min<std::size_t>(4800, phase.size() / 8);
  const double step = pitch.f0 / kAnalysisRate;
  pitch.theta.resize(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    const auto at = static_cast<std::ptrdiff_t>(n) - static_cast<std::ptrdiff_t>(pitch.from);
    const auto inside =
        std::clamp(at, static_cast<std::ptrdiff_t>(edge), static_cast<std::ptrdiff_t>(phase.size() - edge));
    pitch.theta[n] = step * static_cast<double>(at) + phase[inside];
  }
  return pitch;
}

}  // namespace rigsound::analysis
