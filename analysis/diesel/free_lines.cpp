#include "diesel/free_lines.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "diesel/hbwt.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/fft.hpp"
#include "rigsound/dsp/linear_prediction.hpp"

namespace rigsound::analysis {
namespace {

using Wave = std::vector<double>;
using Complex = std::complex<double>;

constexpr int kPredictor = 4, kFewestFrames = 60;
constexpr double kClear = 2;           // 3 dB, for the prediction and for the peak
constexpr double kLowestLine_hz = 30;  // the crank tracker's band begins here
constexpr double kFlutter = 0.08;      // orders: this near to one, its own unsteadiness is found
constexpr double kSame = 0.0012;       // two cents
constexpr double kAsSharp = 0.9;       // of the sharpness over time, to count as locked
constexpr double kBlock_s = 1;         // in which level and phase of a line are measured

/// The residual over time or over crank angle, cut into M channels.
struct View {
  const Wave& y;
  double rate = 0;  // samples a second or a cycle
  int M = 0;
  double orders = 1;  // one unit of frequency, in orders
  double width() const { return rate / (2 * M); }
};

struct Peak {
  double frequency = 0, sharpness = 0;  // power of the peak over that beside it
};

struct LineCandidate {
  std::size_t section = 0;
  double order = 0, hz = 0, sharpness = 0, amplitude = 0;
  bool locked = false;
  double frequency() const { return locked ? order : hz; }
  Lock lock() const { return locked ? Lock::kCrank : Lock::kTime; }
};

bool is_between_orders(double order) { return std::fabs(order - std::round(order)) > kFlutter; }

/// Power over prediction error in the second half of `channel`, predicted by what fits the first.
double prediction_gain(const Wave& channel) {
  const std::size_t half = channel.size() / 2;
  Wave r;
  for (std::size_t lag = 0; lag <= kPredictor; ++lag) {
    double sum = lag == 0 ? 1e-30 : 0;
    for (std::size_t i = 0; i + lag < half; ++i) sum += channel[i] * channel[i + lag];
    r.push_back(sum);
  }
  const Wave a = dsp::levinson(r).a;
  double power = 0, left = 1e-30;
  for (std::size_t i = half; i < channel.size(); ++i) {
    double e = 0;
    for (std::size_t k = 0; k < a.size(); ++k) e += a[k] * channel[i - k];
    power += channel[i] * channel[i], left += e * e;
  }
  return power / left;
}

/// Channels that can be predicted and are louder than both neighbours.
std::vector<int> predictable_channels(const View& view, double lowest, double highest) {
  const Wave X = mdct_frames(view.y, view.M);
  const int frames = static_cast<int>(X.size()) / view.M;
  std::vector<int> found;
  if (frames < kFewestFrames) return found;
  const int first = std::max(1, static_cast<int>(lowest / view.width()));
  const int last = std::min(view.M - 2, static_cast<int>(highest / view.width()));
  Wave power;
  for (int q = first - 1; q <= last + 1; ++q) {
    power.push_back(0);
    for (int r = 1; r + 1 < frames; ++r) power.back() += X[r * view.M + q] * X[r * view.M + q];
  }
  for (int q = first; q <= last; ++q) {
    const auto i = static_cast<std::size_t>(q - first + 1);
    if (power[i] < power[i - 1] || power[i] < power[i + 1]) continue;
    Wave channel;
    for (int r = 1; r + 1 < frames; ++r) channel.push_back(X[r * view.M + q]);
    if (prediction_gain(channel) > kClear) found.push_back(q);
  }
  return found;
}

/// A phase of so many cycles, in 0...1.
double wrapped(double turns) { return turns - std::floor(turns); }

/// Sums of `x` in Hann windows of two hops, half overlapped, turned down by `phase` (cycles) of every sample.
template <class Phase>
std::vector<Complex> turned_down(const Wave& x, std::size_t hop, Phase phase) {
  std::vector<Complex> z;
  for (std::size_t at = 0; at + 2 * hop <= x.size(); at += hop) {
    Complex sum = 0;
    for (std::size_t i = 0; i < 2 * hop; ++i) {
      const double hann = 0.5 - 0.5 * std::cos(M_PI * static_cast<double>(i) / static_cast<double>(hop));
      sum += hann * x[at + i] * std::polar(1.0, -2 * M_PI * phase(at + i));
    }
    z.push_back(sum);
  }
  return z;
}

/// `view` around frequency `centre`, turned down to zero; eight values a channel width.
std::vector<Complex> baseband(const View& view, double centre) {
  return turned_down(view.y, static_cast<std::size_t>(view.M / 4),
                     [&](std::size_t n) { return wrapped(centre / view.rate * static_cast<double>(n)); });
}

/// The strongest peak in channel `q`, if it stands clear of what is half a channel around it.
std::optional<Peak> peak_in(const View& view, int q) {
  const double centre = (q + 0.5) * view.width();
  const std::vector<Complex> z = baseband(view, centre);
  int size = 1;
  while (size < 4 * static_cast<int>(z.size())) size *= 2;
  Wave re(static_cast<std::size_t>(size), 0.0), im(re.size(), 0.0);
  for (std::size_t b = 0; b < z.size(); ++b) {
    const double hann =
        0.5 - 0.5 * std::cos(2 * M_PI * (static_cast<double>(b) + 0.5) / static_cast<double>(z.size()));
    re[b] = hann * z[b].real(), im[b] = hann * z[b].imag();
  }
  dsp::Fft<double>(size).forward(re.data(), im.data());
  const double bin = 8 * view.width() / size;
  const auto power = [&](int k) {
    const auto i = static_cast<std::size_t>((k + size) % size);
    return re[i] * re[i] + im[i] * im[i];
  };
  const int reach = static_cast<int>(0.6 * view.width() / bin);
  int best = 0;
  for (int k = -reach; k <= reach; ++k)
    if (power(k) > power(best)) best = k;
  // A Hann window's main lobe is four bins of the unpadded length wide.
  const double seen = static_cast<double>(view.y.size()) / view.rate;
  const int narrow = static_cast<int>(std::max(3 / seen, view.width() / 10) / bin);
  double line = 0, beside = 1e-30;
  for (int k = -static_cast<int>(view.width() / 2 / bin); k <= view.width() / 2 / bin; ++k)
    (std::abs(k) <= narrow ? line : beside) += power(best + k);
  if (line < kClear * beside) return std::nullopt;
  const double a = std::log(power(best - 1)), b = std::log(power(best)), c = std::log(power(best + 1));
  return Peak{centre + bin * (best + 0.5 * (a - c) / (a - 2 * b + c)), line / beside};
}

std::vector<Peak> peaks_of(const View& view, double lowest, double highest) {
  std::vector<Peak> peaks;
  for (const int q : predictable_channels(view, lowest, highest)) {
    const std::optional<Peak> peak = peak_in(view, q);
    if (!peak) continue;
    if (is_between_orders(peak->frequency * view.orders)) peaks.push_back(*peak);
  }
  return peaks;
}

/// Half the complex amplitude of a line in blocks of kBlock_s, half overlapped.
std::vector<Complex> envelope(const Wave& x, const Wave& phase) {
  const auto hop = static_cast<std::size_t>(kBlock_s * kAnalysisRate / 2);
  std::vector<Complex> c = turned_down(x, hop, [&](std::size_t n) { return phase[n]; });
  for (Complex& block : c) block /= static_cast<double>(hop);
  return c;
}

/// Phase of a line at every sample, cycles in 0...1.
Wave phase_of(const Section& s, double frequency, Lock lock) {
  Wave phase;
  phase.reserve(s.theta.size());
  for (std::size_t n = 0; n < s.theta.size(); ++n) {
    const double turns =
        frequency * (lock == Lock::kCrank ? s.theta[n] : static_cast<double>(n) / kAnalysisRate);
    phase.push_back(wrapped(turns));
  }
  return phase;
}

double amplitude_of(const SectionResidual& residual, const LineCandidate& line) {
  const std::vector<Complex> c =
      envelope(*residual.x, phase_of(*residual.section, line.frequency(), line.lock()));
  Complex product = 0;  // of blocks that share no sample, so no noise
  for (std::size_t b = 0; b + 2 < c.size(); ++b) product += c[b] * std::conj(c[b + 2]);
  return c.size() < 3 ? 0 : 2 * std::sqrt(std::abs(product) / static_cast<double>(c.size() - 2));
}

std::vector<Peak> peaks_over_angle(const SectionResidual& residual, int N, double lowest, double highest) {
  const CycleBlock block = cycles_of(*residual.section, *residual.x, 0, N);
  return peaks_of({block.y, static_cast<double>(N), N, 1}, lowest, highest);
}

/// The lines of one section, each over time or over angle, where it is sharper.
std::vector<LineCandidate> candidates_of(const SectionResidual& residual, std::size_t section, int N) {
  const Section& s = *residual.section;
  const double f0 = s.f0(), highest = 0.95 * s.nyquist_hz;
  const int M = 1 << static_cast<int>(std::log2(kAnalysisRate / f0));
  const View time{*residual.x, kAnalysisRate, M, 1 / f0};
  std::vector<LineCandidate> found;
  for (const Peak& p : peaks_over_angle(residual, N, kLowestLine_hz / f0, highest / f0))
    found.push_back({section, p.frequency, p.frequency * f0, p.sharpness, 0, true});
  for (const Peak& p : peaks_of(time, kLowestLine_hz, highest)) {
    const double order = p.frequency / f0;
    const auto other = std::find_if(found.begin(), found.end(), [&](const LineCandidate& c) {
      return c.locked && std::fabs(c.order - order) < kFlutter;
    });
    if (other == found.end())
      found.push_back({section, order, p.frequency, p.sharpness, 0, false});
    else if (other->sharpness < kAsSharp * p.sharpness)
      *other = {section, order, p.frequency, p.sharpness, 0, false};
  }
  for (LineCandidate& c : found) c.amplitude = amplitude_of(residual, c);
  return found;
}

bool same(double a, double b) { return std::fabs(a / b - 1) < kSame; }

/// Whether both lie at the frequency that `lock` keeps.
bool matches(const LineCandidate& c, const LineCandidate& other, Lock lock) {
  return lock == Lock::kCrank ? same(c.order, other.order) : same(c.hz, other.hz);
}

/// `first` and the lines of the other sections at its frequency, one a section.
std::vector<LineCandidate> matching_lines(const LineCandidate& first, const std::vector<LineCandidate>& pool,
                                          Lock lock) {
  std::vector<LineCandidate> lines = {first};
  for (const LineCandidate& c : pool) {
    const bool taken = std::any_of(lines.begin(), lines.end(),
                                   [&](const LineCandidate& k) { return k.section == c.section; });
    if (matches(c, first, lock) && !taken) lines.push_back(c);
  }
  return lines;
}

/// Sections in which a line like `c` is far enough from the orders to be resolved.
std::size_t resolvable_sections(const LineCandidate& c, Lock lock,
                                const std::vector<SectionResidual>& residuals) {
  if (lock == Lock::kCrank) return residuals.size();
  return static_cast<std::size_t>(
      std::count_if(residuals.begin(), residuals.end(),
                    [&](const SectionResidual& r) { return is_between_orders(c.hz / r.section->f0()); }));
}

FreeLine joined(const std::vector<LineCandidate>& lines, Lock lock, std::size_t sections) {
  const auto count = static_cast<double>(lines.size());
  const bool locked = lock == Lock::kCrank;
  FreeLine line;
  line.tone.order_locked = locked;
  double power = 0;
  for (const LineCandidate& c : lines) {
    line.tone.frequency += (locked ? c.order : c.hz) / count;
    power += c.amplitude * c.amplitude / count;
  }
  line.tone.amplitude = std::sqrt(power);
  line.frequency.assign(sections, line.tone.frequency);
  for (const LineCandidate& c : lines) line.frequency[c.section] = locked ? c.order : c.hz;
  return line;
}

}  // namespace

std::vector<FreeLine> free_lines(const std::vector<SectionResidual>& residuals, int N) {
  std::vector<FreeLine> lines;
  std::vector<LineCandidate> pool;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!residuals[i].section->open.empty()) return lines;
    const std::vector<LineCandidate> found = candidates_of(residuals[i], i, N);
    pool.insert(pool.end(), found.begin(), found.end());
  }
  std::sort(pool.begin(), pool.end(),
            [](const LineCandidate& a, const LineCandidate& b) { return a.amplitude > b.amplitude; });
  while (!pool.empty()) {
    const LineCandidate first = pool.front();
    pool.erase(pool.begin());
    const std::vector<LineCandidate> by_order = matching_lines(first, pool, Lock::kCrank),
                                     by_hz = matching_lines(first, pool, Lock::kTime);
    const bool locked = by_order.size() == by_hz.size() ? first.locked : by_order.size() > by_hz.size();
    const Lock lock = locked ? Lock::kCrank : Lock::kTime;
    const std::vector<LineCandidate>& matching = locked ? by_order : by_hz;
    pool.erase(std::remove_if(pool.begin(), pool.end(),
                              [&](const LineCandidate& c) { return matches(c, first, lock); }),
               pool.end());
    if (2 * matching.size() > resolvable_sections(first, lock, residuals))
      lines.push_back(joined(matching, lock, residuals.size()));
  }
  return lines;
}

std::vector<double> without_line(const Section& section, std::vector<double> x, double frequency, Lock lock) {
  const Wave phase = phase_of(section, frequency, lock);
  const std::vector<Complex> c = envelope(x, phase);
  if (c.empty()) return x;
  const double hop = kBlock_s * kAnalysisRate / 2;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double at = std::clamp(static_cast<double>(n) / hop - 1, 0.0, static_cast<double>(c.size() - 1));
    const auto b = std::min(static_cast<std::size_t>(at), c.size() - 1), next = std::min(b + 1, c.size() - 1);
    const Complex now = c[b] + (at - static_cast<double>(b)) * (c[next] - c[b]);
    x[n] -= 2 * (now * std::polar(1.0, 2 * M_PI * phase[n])).real();
  }
  return x;
}

}  // namespace rigsound::analysis
