#include "tool_fit/decay_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoPower = 1e-30;
constexpr double kShortest_s = 0.004, kLongest_s = 60, kGridStep = 1.1;  // T60 that are tried
constexpr std::size_t kFewestPoints = 8;  // independent values that a course is fitted to
constexpr std::size_t kMostPoints = 256;  // more are averaged
constexpr double kBeat_db = 2;            // what modes that beat too slowly to be seen may add to the fall
constexpr double kWidest = 4;             // a told decay is known to a factor of two either way
constexpr double kLeastSpread = 0.02;     // dispersion; no recording is as regular as a formula

double third_octave_width(double centre_hz) {
  return centre_hz * (std::pow(2, 1.0 / 6) - std::pow(2, -1.0 / 6));
}

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

/// Powers of a band at independent moments.
struct Course {
  std::vector<double> power, time_s;
};

/// Every `step`-th value of `power` in from...to, `step` as small as independence allows; long courses in
/// blocks.
Course course(const std::vector<double>& power, double from, double to, double step) {
  Course all;
  for (double at = from; at < to; at += step) {
    all.power.push_back(power[static_cast<std::size_t>(at)] + kNoPower);
    all.time_s.push_back((at - from) / kAnalysisRate);
  }
  const std::size_t block = (all.power.size() + kMostPoints - 1) / kMostPoints;
  if (block <= 1) return all;
  Course blocks;
  for (std::size_t i = 0; i + block <= all.power.size(); i += block) {
    const auto first = static_cast<long>(i), end = static_cast<long>(i + block);
    blocks.power.push_back(mean({all.power.begin() + first, all.power.begin() + end}));
    blocks.time_s.push_back(mean({all.time_s.begin() + first, all.time_s.begin() + end}));
  }
  return blocks;
}

/// A exp(-a t) + N with the A and N that are likeliest for one a.
struct CourseFit {
  double rate = 0;  ///< a, of power, 1/s
  double A = 0, N = 0, deviance = kInfinity;

  double at(double t) const { return A * std::exp(-rate * t) + N; }
};

double deviance(const Course& c, const CourseFit& fit) {
  double sum = 0;
  for (std::size_t i = 0; i < c.power.size(); ++i) {
    const double ratio = c.power[i] / fit.at(c.time_s[i]);
    sum += 2 * (ratio - 1 - std::log(ratio));
  }
  return sum;
}

/// Multiplicative updates (Itakura-Saito divergence) from `start`; N stays up to `most_noise`.
CourseFit fit_at(const Course& c, double rate, CourseFit start, double most_noise) {
  constexpr int kIterations = 40;
  CourseFit fit = start;
  fit.rate = rate;
  if (rate == 0) {
    fit.A = mean(c.power), fit.N = 0;
    fit.deviance = deviance(c, fit);
    return fit;
  }
  std::vector<double> fall;
  for (const double t : c.time_s) fall.push_back(std::exp(-rate * t));
  for (int k = 0; k < kIterations; ++k) {
    double up_A = 0, down_A = kNoPower, up_N = 0, down_N = kNoPower;
    for (std::size_t i = 0; i < fall.size(); ++i) {
      const double v = fit.A * fall[i] + fit.N, ratio = c.power[i] / (v * v);
      up_A += fall[i] * ratio, down_A += fall[i] / v;
      up_N += ratio, down_N += 1 / v;
    }
    fit.A *= std::sqrt(up_A / down_A);
    fit.N = std::min(most_noise, fit.N * std::sqrt(up_N / down_N));
  }
  fit.deviance = deviance(c, fit);
  return fit;
}

/// Of power, 1/s; and the other way round.
double rate_of(double t60_s) { return 6 * std::log(10.0) / t60_s; }

/// From the shortest to the longest decay, none last.
std::vector<CourseFit> profile(const Course& c, double most_noise) {
  std::vector<CourseFit> fits;
  CourseFit start;
  start.A = *std::max_element(c.power.begin(), c.power.end());
  start.N = std::min(most_noise, c.power.back());
  for (double t60 = kShortest_s; t60 < kLongest_s; t60 *= kGridStep) {
    start = fit_at(c, rate_of(t60), start, most_noise);
    fits.push_back(start);
  }
  fits.push_back(fit_at(c, 0, start, most_noise));
  return fits;
}

/// How much further from the model the powers lie than independent exponential ones would: their spread
/// times the correlation from value to value (Bartlett's window).
double spread(const Course& c, const CourseFit& fit) {
  std::vector<double> residual;
  double square = 0;
  for (std::size_t i = 0; i < c.power.size(); ++i) {
    residual.push_back(c.power[i] / fit.at(c.time_s[i]) - 1);
    square += residual.back() * residual.back();
  }
  const std::size_t lags = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(residual.size())));
  double correlation = 1;
  for (std::size_t k = 1; k <= lags; ++k) {
    double product = 0;
    for (std::size_t i = k; i < residual.size(); ++i) product += residual[i] * residual[i - k];
    correlation += 2 * (1 - static_cast<double>(k) / static_cast<double>(lags + 1)) * product / square;
  }
  const double free = static_cast<double>(residual.size()) - 3;
  return std::max(kLeastSpread, square / free * std::max(1.0, correlation));
}

/// Not under the square of Student's t for n - 3 degrees of freedom, 95 %.
double student_square(std::size_t n) { return 3.84 * (1 + 6 / static_cast<double>(n)); }

/// The likeliest T60 within a step of the grid around `start`, by golden section.
CourseFit refined(const Course& c, const CourseFit& start, double most_noise) {
  constexpr double kGolden = 0.618034;
  constexpr int kCuts = 20;
  double low = start.rate / kGridStep, high = start.rate * kGridStep;
  CourseFit below = fit_at(c, high - kGolden * (high - low), start, most_noise),
            above = fit_at(c, low + kGolden * (high - low), start, most_noise);
  for (int i = 0; i < kCuts; ++i) {
    if (below.deviance < above.deviance) {
      high = above.rate, above = below;
      below = fit_at(c, high - kGolden * (high - low), above, most_noise);
    } else {
      low = below.rate, below = above;
      above = fit_at(c, low + kGolden * (high - low), below, most_noise);
    }
  }
  const CourseFit& better = below.deviance < above.deviance ? below : above;
  return better.deviance < start.deviance ? better : start;
}

/// T60 at which the deviance crosses `limit`, between one with less and one with more.
double crossing_s(const Course& c, CourseFit inside, CourseFit outside, double limit, double most_noise) {
  constexpr int kCuts = 16;
  for (int i = 0; i < kCuts; ++i) {
    const CourseFit middle = fit_at(c, 0.5 * (inside.rate + outside.rate), inside, most_noise);
    (middle.deviance <= limit ? inside : outside) = middle;
  }
  return rate_of(outside.rate);  // its own inverse
}

/// From the beginning until the end, or until the noise is reached.
double heard_s(const Course& c, const CourseFit& fit) {
  const double length = c.time_s.back();
  if (fit.rate == 0 || fit.N <= 0) return length;
  return std::clamp(std::log(fit.A / fit.N) / fit.rate, 1e-3, length);
}

/// `noise`: set to that of the likeliest course.
DecayBounds bounds_of(const Course& c, double most_noise, double& noise) {
  DecayBounds bounds;
  if (c.power.size() < kFewestPoints) return bounds;
  const std::vector<CourseFit> fits = profile(c, most_noise);
  const CourseFit coarse = *std::min_element(
      fits.begin(), fits.end(), [](const auto& x, const auto& y) { return x.deviance < y.deviance; });
  const CourseFit best = coarse.rate > 0 ? refined(c, coarse, most_noise) : coarse;
  const double limit = best.deviance + spread(c, best) * student_square(c.power.size());
  const double heard = heard_s(c, best), beat = kBeat_db / 60 / heard;  // of 1 / T60
  bounds.heard_db = 60 * heard * best.rate / rate_of(1);
  noise = best.N;
  // From the best towards shorter and longer decays, the first that is too unlikely.
  const auto unlikely = [&](const CourseFit& fit) { return fit.deviance > limit; };
  const auto first_longer = std::find_if(
      fits.begin(), fits.end(), [&](const CourseFit& fit) { return fit.rate < best.rate && unlikely(fit); });
  const auto first_shorter = std::find_if(fits.rbegin(), fits.rend(), [&](const CourseFit& fit) {
    return fit.rate > best.rate && unlikely(fit);
  });
  if (first_shorter != fits.rend())
    bounds.low_s = 1 / (1 / crossing_s(c, best, *first_shorter, limit, most_noise) + beat);
  if (first_longer == fits.end() || first_longer->rate == 0 || bounds.heard_db < kHeardFall_db) return bounds;
  const double slowest = 1 / crossing_s(c, best, *first_longer, limit, most_noise) - beat;
  if (slowest * kWidest * bounds.low_s < 1) return bounds;
  bounds.high_s = 1 / slowest;
  bounds.t60_s = rate_of(best.rate);
  return bounds;
}

/// `n` independent values, of which noise is `noise` of the energy. Signal and noise add with a cross term.
SignalShare share_of(double noise, double n) {
  const double deviation = 2 * std::sqrt((2 * noise + noise * noise) / n);
  return {std::clamp(1 - noise - deviation, 0.0, 1.0), std::max(kNoPower, 1 - noise + deviation)};
}

}  // namespace

DecayEvidence::DecayEvidence(const RecordedImpact& impact)
    : onset_(impact.before.size()), samples_(impact.before.size() + impact.sound.size() - kBeforeImpact) {
  constexpr std::size_t kRoom = 1 << 14;  // for what the filters smear, samples
  std::vector<std::complex<double>> x(impact.before.begin(), impact.before.end());
  x.insert(x.end(), impact.sound.begin() + kBeforeImpact, impact.sound.end());
  size_ = 1;
  while (size_ < samples_ + kRoom) size_ *= 2;
  x.resize(size_);
  fft_.fwd(spectrum_, x);
}

/// Power of the band through a Gaussian filter, which neither rings nor lets the neighbours through.
std::vector<double> DecayEvidence::band_power(double centre_hz, double width_hz) {
  const double hz_a_bin = kAnalysisRate / static_cast<double>(size_), sigma = width_hz / 2.5;
  std::vector<std::complex<double>> band(size_), sound;
  for (std::size_t k = 1; k < size_ / 2; ++k) {
    const double off = (static_cast<double>(k) * hz_a_bin - centre_hz) / sigma;
    band[k] = 2 * std::exp(-0.5 * off * off) * spectrum_[k];
  }
  fft_.inv(sound, band);
  std::vector<double> power;
  for (std::size_t n = 0; n < samples_; ++n) power.push_back(std::norm(sound[n]));
  return power;
}

BandEvidence DecayEvidence::band(double centre_hz) {
  constexpr double kNoiseWidth = 0.709;  // of the filter, in third octaves
  const double width = third_octave_width(centre_hz), smear = kAnalysisRate / width,
               step = smear / kNoiseWidth;
  const std::vector<double> power = band_power(centre_hz, width);
  const auto onset = static_cast<double>(onset_), end = static_cast<double>(samples_);
  const Course noise = course(power, 0.8 * smear, onset - smear, step),
               ringing = course(power, onset + smear, end - 0.8 * smear, step);
  const bool heard_before = noise.power.size() >= 4;
  const double before = heard_before ? mean(noise.power) : 0,
               most_noise = heard_before
                                ? before * (1 + 3 / std::sqrt(static_cast<double>(noise.power.size())))
                                : kInfinity;
  double under = 0;
  BandEvidence evidence;
  evidence.decay = bounds_of(ringing, most_noise, under);
  const double energy = std::accumulate(power.begin() + static_cast<long>(onset_), power.end(), kNoPower);
  evidence.share = share_of(std::min(1.0, (heard_before ? before : under) * (end - onset) / energy),
                            std::max(1.0, (end - onset) / step));
  return evidence;
}

}  // namespace rigsound::analysis
