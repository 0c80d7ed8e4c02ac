#include "diesel/likeness.hpp"

#include <algorithm>
#include <cmath>

#include "diesel/angle_domain.hpp"
#include "diesel/order_spectrum.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kWelchCycles = 16;
constexpr double kLowestThird_hz = 40;
constexpr double kStanding_db = 10;
constexpr double kEnvelopeFloor = 0.01, kModulationFloor = 1e-3;

int welch_cycles(std::size_t samples, int N) {
  const int most = static_cast<int>(samples) / N / 3;
  int cycles = 1;
  while (2 * cycles <= std::min(kWelchCycles, most)) cycles *= 2;
  return cycles;
}

/// Mean power of a band in kEnvelopeSlots parts of every cycle.
std::vector<double> band_power(const CyclicSound& s, double low_hz, double high_hz) {
  const double rate = s.N * s.f0;
  const std::vector<double> z = zero_phase_low_pass(zero_phase_high_pass(s.y, low_hz, rate), high_hz, rate);
  const std::size_t part = static_cast<std::size_t>(s.N / kEnvelopeSlots);
  std::vector<double> e(z.size() / part);
  for (std::size_t i = 0; i < e.size(); ++i)
    for (std::size_t j = 0; j < part; ++j)
      e[i] += z[i * part + j] * z[i * part + j] / static_cast<double>(part);
  return e;
}

std::vector<double> mean_over_cycles(const std::vector<double>& e) {
  std::vector<double> profile(kEnvelopeSlots, 0.0);
  double mean = 0;
  const std::size_t cycles = e.size() / kEnvelopeSlots;
  for (std::size_t i = 0; i < cycles * kEnvelopeSlots; ++i) profile[i % kEnvelopeSlots] += e[i], mean += e[i];
  for (double& v : profile) v *= kEnvelopeSlots / mean;
  return profile;
}

/// Power of the relative envelope at modulation orders 1...16 and in the bands between them, dB.
std::vector<double> modulation(std::vector<double> e) {
  double mean = 0;
  for (const double v : e) mean += v / static_cast<double>(e.size());
  for (double& v : e) v = v / mean - 1;
  const int cycles = welch_cycles(e.size(), kEnvelopeSlots);
  const std::vector<double> power = order_spectrum(e, kEnvelopeSlots, cycles);
  constexpr double kNear = 0.13, kBetweenOrders[][2] = {{.2, .45},  {.55, .9},   {1.1, 2.9},
                                                        {3.1, 5.9}, {6.1, 11.9}, {12.1, 24}};
  std::vector<double> at_order(17, 0.0), between(std::size(kBetweenOrders), 0.0);
  for (std::size_t b = 1; b < power.size(); ++b) {
    const double order = static_cast<double>(b) / cycles, nearest = std::round(order);
    if (std::fabs(order - nearest) < kNear) {
      if (nearest >= 1 && nearest <= 16) at_order[static_cast<std::size_t>(nearest)] += power[b];
      continue;
    }
    for (std::size_t i = 0; i < between.size(); ++i)
      if (order >= kBetweenOrders[i][0] && order < kBetweenOrders[i][1]) between[i] += power[b];
  }
  std::vector<double> db;
  for (std::size_t k = 1; k < at_order.size(); ++k)
    db.push_back(10 * std::log10(at_order[k] + kModulationFloor));
  for (const double v : between) db.push_back(10 * std::log10(v + kModulationFloor));
  return db;
}

/// How far the highest bin within an eighth of an order of each order stands above the mean of what lies
/// within an eighth of midway to its neighbours, dB; order k at index k.
std::vector<double> order_heights(const CyclicSound& s) {
  const int cycles = welch_cycles(s.y.size(), s.N);
  const std::vector<double> power = order_spectrum(s.y, s.N, cycles);
  const auto mean = [&](double from, double to) {
    double sum = 0;
    const auto first = static_cast<std::size_t>(std::lround(from * cycles)),
               last = static_cast<std::size_t>(std::lround(to * cycles));
    for (std::size_t b = first; b <= last; ++b) sum += power[b] / static_cast<double>(last - first + 1);
    return sum + 1e-30;
  };
  std::vector<double> db = {0};
  for (int k = 1; (k + 1) * cycles < static_cast<int>(power.size()); ++k) {
    const double floor = 0.5 * (mean(k - 0.625, k - 0.375) + mean(k + 0.375, k + 0.625));
    const auto near = power.begin() + std::lround((k - 0.125) * cycles);
    db.push_back(10 * std::log10(*std::max_element(near, near + cycles / 4 + 1) / floor));
  }
  return db;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

std::vector<double> envelope_bands(double highest_hz) {
  std::vector<double> edges;
  for (double f = 100; f <= std::min(12800.0, highest_hz); f *= 2) edges.push_back(f);
  return edges;
}

std::vector<double> fractional_octaves(const CyclicSound& s, int fraction, double lowest_hz,
                                       double highest_hz) {
  const int cycles = welch_cycles(s.y.size(), s.N);
  const std::vector<double> power = order_spectrum(s.y, s.N, cycles);
  const double step = std::pow(2.0, 1.0 / fraction), edge = std::sqrt(step);
  std::vector<double> db;
  for (double centre = lowest_hz; centre < highest_hz; centre *= step) {
    if (centre <= 1.5 * s.f0) continue;
    double sum = 1e-30;
    for (std::size_t b = 0; b < power.size(); ++b) {
      const double f = static_cast<double>(b) / cycles * s.f0;
      if (f >= centre / edge && f < centre * edge) sum += power[b];
    }
    db.push_back(10 * std::log10(sum));
  }
  return db;
}

double valley_depth(const std::vector<double>& levels_db, std::size_t group) {
  double sum = 0;
  const std::size_t groups = levels_db.size() / group;
  for (std::size_t g = 0; g < groups; ++g) {
    const auto [low, high] =
        std::minmax_element(levels_db.begin() + static_cast<std::ptrdiff_t>(g * group),
                            levels_db.begin() + static_cast<std::ptrdiff_t>((g + 1) * group));
    sum += *high - *low;
  }
  return sum / static_cast<double>(groups);
}

StandingOrders standing_orders(const CyclicSound& a, const CyclicSound& reference, double lowest_hz,
                               double highest_hz) {
  const std::vector<double> heights = order_heights(a), wanted = order_heights(reference);
  StandingOrders orders;
  const auto last = static_cast<std::size_t>(highest_hz / reference.f0);
  for (auto k = static_cast<std::size_t>(std::ceil(lowest_hz / reference.f0));
       k <= std::min({last, heights.size() - 1, wanted.size() - 1}); ++k) {
    if (wanted[k] < kStanding_db) continue;
    ++orders.count;
    orders.lost_db += wanted[k] - heights[k];
  }
  if (orders.count > 0) orders.lost_db /= orders.count;
  return orders;
}

std::vector<double> cyclic_envelope(const CyclicSound& s, double low_hz, double high_hz) {
  return mean_over_cycles(band_power(s, low_hz, high_hz));
}

Likeness likeness(const CyclicSound& a, const CyclicSound& b, double highest_hz) {
  Likeness result;
  result.third_octave_db = rms_difference(fractional_octaves(a, 3, kLowestThird_hz, highest_hz),
                                          fractional_octaves(b, 3, kLowestThird_hz, highest_hz));
  const std::vector<double> edges = envelope_bands(std::min(highest_hz, 0.45 * a.N * a.f0));
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const std::vector<double> ea = band_power(a, edges[i], edges[i + 1]),
                              eb = band_power(b, edges[i], edges[i + 1]);
    std::vector<double> pa = mean_over_cycles(ea), pb = mean_over_cycles(eb);
    for (double& v : pa) v = 10 * std::log10(v + kEnvelopeFloor);
    for (double& v : pb) v = 10 * std::log10(v + kEnvelopeFloor);
    const double bands = static_cast<double>(edges.size() - 1);
    result.cyclic_envelope_db += rms_difference(pa, pb) / bands;
    result.modulation_db += rms_difference(modulation(ea), modulation(eb)) / bands;
  }
  return result;
}

}  // namespace rigsound::analysis
