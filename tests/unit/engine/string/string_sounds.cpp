#include "engine/string/string_sounds.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/tool/sound_levels.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::tests {
namespace {

using namespace string;

/// Modified Bessel function of order 0.
double bessel_i0(double x) {
  double sum = 1, term = 1;
  for (int k = 1; k < 60; ++k) sum += term *= x * x / (4.0 * k * k);
  return sum;
}

std::vector<double> highpass_taps() {
  constexpr int kHalf = 800;
  constexpr double kCut = 2 * 12350 / kStringRate, kBeta = 17;
  std::vector<double> taps;
  for (int i = -kHalf; i <= kHalf; ++i) {
    const double u = static_cast<double>(i) / kHalf;
    const double window = bessel_i0(kBeta * std::sqrt(1 - u * u)) / bessel_i0(kBeta);
    const double low = i == 0 ? kCut : std::sin(M_PI * kCut * i) / (M_PI * i);
    taps.push_back((i == 0) - low * window);
  }
  return taps;
}

std::complex<double> projection(const std::vector<double>& sound, std::size_t from, std::size_t count,
                                double omega) {
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double window =
        1 - std::cos(2 * M_PI * (static_cast<double>(n) + 0.5) / static_cast<double>(count));
    sum += window * sound[from + n] * std::polar(1.0, -omega * static_cast<double>(n));
  }
  return sum;
}

/// Zero at a mode of the free-free bar, symmetric or not; the hyperbolic cosine is divided out.
double characteristic(double omega, double length, double diameter, bool symmetric) {
  constexpr double kC = 5200, nu = 0.30;
  const double shear = 6 * (1 + nu) * (1 + nu) / (7 + 12 * nu + 4 * nu * nu), e = 2 * (1 + nu) / shear;
  const double S = omega * omega / (kC * kC), O = e * S, r2 = diameter * diameter / 16, h = length / 2;
  const double q = std::sqrt((S - O) * (S - O) / 4 + S / r2);
  const double a = std::sqrt(q + (S + O) / 2), b = std::sqrt(q - (S + O) / 2), th = std::tanh(b * h);
  const double even = (O - a * a) / b * std::cos(a * h) * th - (O + b * b) / a * std::sin(a * h);
  const double odd = (O - a * a) / b * std::sin(a * h) + (O + b * b) / a * th * std::cos(a * h);
  return symmetric ? even : odd;
}

}  // namespace

StringModel plain_string(double length_m, double diameter_m, int rods) {
  StringModel model;
  model.rod_length_m = length_m;
  model.rod_diameter_m = diameter_m;
  model.rods = rods;
  model.amplitude_variation = 0;
  model.bounces = 0;
  return model;
}

StringModel bare_string(double length_m, int rods) {
  StringModel model = plain_string(length_m, 0.038, rods);
  model.shank_length_m = 0;
  model.sleeve_impedance = 1;
  model.string_low_s = model.string_high_s = 30;
  return model;
}

std::vector<double> struck(StringLayer& layer, const StringBlows& blows,
                           const std::function<StringInput(double)>& input) {
  std::vector<double> sound;
  double next_s = blows.first_s;
  std::uint64_t index = 0;
  while (static_cast<double>(sound.size()) < blows.seconds * kStringRate) {
    const double now = static_cast<double>(sound.size());
    Impact impact;
    int count = 0;
    if (next_s * kStringRate < now + kChunk && next_s < blows.until_s) {
      impact = {next_s * kStringRate - now, 1, index++};
      count = 1;
      next_s += blows.period_s;
    }
    double out[kChunk];
    layer.process(input(now / kStringRate), {&impact, count}, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  return sound;
}

std::vector<double> free_ringing(const StringModel& model, double seconds, dsp::LaneWidth width,
                                 double contact) {
  LongitudinalString line(model, kStringRate, width);
  line.set_contact(contact);
  line.bit().set_gap(-1);
  double in[kChunk] = {0.5, 1, 0.5}, none[kChunk] = {}, heard[kChunk];
  std::vector<double> sound;
  for (int n = 0; n < seconds * kStringRate; n += kChunk) {
    line.process({n == 0 ? in : none, none, heard});
    sound.insert(sound.end(), heard, heard + kChunk);
  }
  return sound;
}

double frequency_near(const std::vector<double>& sound, double hz, double rate) {
  double omega = 2 * M_PI * hz / rate;
  for (const std::size_t shift : {sound.size() / 48, sound.size() / 12, sound.size() / 3}) {
    const std::size_t count = sound.size() - sound.size() / 3 - 100;
    const auto turned = projection(sound, 100 + shift, count, omega) / projection(sound, 100, count, omega) *
                        std::polar(1.0, -omega * static_cast<double>(shift));
    omega += std::arg(turned) / static_cast<double>(shift);
  }
  return omega * rate / (2 * M_PI);
}

double energy_within(const std::vector<double>& sound, double from_s, double to_s) {
  double sum = 0;
  for (auto n = static_cast<std::size_t>(from_s * kStringRate);
       n < static_cast<std::size_t>(to_s * kStringRate); ++n)
    sum += sound[n] * sound[n];
  return sum;
}

double residue_above_modes_db(const std::vector<double>& sound, double from_s, double to_s) {
  static const std::vector<double> taps = highpass_taps();
  double peak = 0, high = 0;
  for (const double x : sound) peak = std::max(peak, std::fabs(x));
  const auto from = static_cast<std::size_t>(from_s * kStringRate);
  const auto to = std::min(static_cast<std::size_t>(to_s * kStringRate), sound.size()) - taps.size();
  for (std::size_t n = from; n < to; ++n) {
    double sum = 0;
    for (std::size_t i = 0; i < taps.size(); ++i) sum += taps[i] * sound[n + i];
    high = std::max(high, std::fabs(sum));
  }
  return 20 * std::log10(high / peak);
}

double third_octave_distance_db(const std::vector<double>& a, const std::vector<double>& b) {
  const auto A = third_octaves_db(a, kStringRate), B = third_octaves_db(b, kStringRate);
  double sum = 0;
  for (std::size_t i = 0; i < A.size(); ++i) sum += std::fabs(A[i] - B[i]);
  return sum / static_cast<double>(A.size());
}

std::vector<double> timoshenko_modes(double length_m, double diameter_m, double highest_hz) {
  std::vector<double> modes;
  for (const bool symmetric : {true, false}) {
    const auto f = [&](double root_hz) {
      return characteristic(2 * M_PI * root_hz * root_hz, length_m, diameter_m, symmetric);
    };
    // Modes are about evenly spaced in the root of their frequency; half of the distance from 0 to the first.
    const double step = std::sqrt(5200 * diameter_m / (length_m * length_m)) / 20;
    for (double root = step; root * root < highest_hz; root += step) {
      double low = root, high = root + step;
      if (f(low) * f(high) > 0) continue;
      for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (f(low) * f(middle) <= 0 ? high : low) = middle;
      }
      if (low * low < highest_hz) modes.push_back(low * low);
    }
  }
  std::sort(modes.begin(), modes.end());
  return modes;
}

double gliding_residue_db(const StringModel& model, double from_m, double to_m, double speed_m_per_s) {
  constexpr int kChunksABlow = 3000;  // two seconds
  BendingModes bank(model, kStringRate, dsp::widest_lanes());
  const double step = speed_m_per_s * kChunk / kStringRate;
  const int chunks = static_cast<int>((from_m - to_m) / step);
  double blow[kChunk] = {0, 0.1, 0.4, 0.8, 1, 0.8, 0.4, 0.1}, none[kChunk] = {}, out[kChunk];
  std::vector<double> sound;
  for (int i = 0; i < chunks; ++i) {
    const bool struck = i % kChunksABlow == 0;
    bank.set(from_m - step * i, 0);
    bank.process(struck ? blow : none, struck, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  double worst = -300;
  const double a_blow_s = kChunksABlow * kChunk / kStringRate,
               seconds = static_cast<double>(sound.size()) / kStringRate;
  for (double at = 0; at + 0.4 < seconds; at += a_blow_s)
    worst = std::max(worst, residue_above_modes_db(sound, at + 0.3, std::min(at + a_blow_s - 0.01, seconds)));
  return worst;
}

double largest_string_growth(const StringModel& model, int chunks, dsp::LaneWidth width) {
  LongitudinalString line(model, kStringRate, width);
  const dsp::RandomField random(11, 1);
  double in[kChunk] = {1, 1, 1, 1, -0.5, 2, 1}, none[kChunk] = {}, heard[kChunk];
  line.bit().set_return(0.004);
  double before = 0, worst = -1;
  for (int i = 0; i < chunks; ++i) {
    const auto n = static_cast<std::uint64_t>(i);
    const bool hit = i == 0 || before < 1e-12;
    const double kind = random.uniform(n, 0);
    line.bit().set_loading(dsp::exp(8 * random.uniform(n, 1) - 4));
    line.bit().set_gap(kind < 0.3 ? 0 : kind < 0.5 ? -1 : 10 * random.uniform(n, 2));
    line.set_contact(random.uniform(n, 4));
    if (i % 50 == 20) line.part();
    if (i % 50 == 49) line.restring(1 + static_cast<int>(3 * random.uniform(n, 3))), before = 0;
    // What is set must not make energy by itself; waves that lose it at once would hide that.
    if (!hit && before > 0) worst = std::max(worst, line.energy() / before - 1);
    before = line.energy();
    line.process({hit ? in : none, none, heard});
    const double after = line.energy();
    if (!hit && before > 0) worst = std::max(worst, after / before - 1);
    before = after;
  }
  return worst;
}

double largest_bending_growth(const StringModel& model, int chunks, dsp::LaneWidth width) {
  StringModel lasting = model;
  lasting.bending_low_s = lasting.bending_high_s = lasting.contact_low_s = lasting.contact_high_s = 30;
  BendingModes bank(lasting, kStringRate, width);
  const dsp::RandomField random(12, 1);
  double in[kChunk] = {1, 1, 1, 1, -0.5, 2, 1}, none[kChunk] = {}, out[kChunk];
  double before = 0, worst = -1;
  for (int i = 0; i < chunks; ++i) {
    const auto n = static_cast<std::uint64_t>(i);
    const bool hit = i % 100 == 0;
    bank.set(model.rod_length_m * (0.04 + 0.96 * random.uniform(n, 0)), random.uniform(n, 1));
    bank.process(hit ? in : none, hit, out);
    const double after = bank.energy();
    if (!hit && before > 0) worst = std::max(worst, after / before - 1);
    before = after;
  }
  return worst;
}

double largest_reflection_error(int samples) {
  const std::vector<double> pulse(static_cast<std::size_t>(samples), 1.0);
  double worst = 0;
  for (double x = 0.25; x <= 3.0001; x += 0.01) {
    const double r = 1 - 4 * (1 - std::exp(-x)) / x + 2 * (1 - std::exp(-2 * x)) / x;
    worst = std::max(worst, std::fabs(played_reflection(pulse, samples / x).energy / r - 1));
  }
  return worst;
}

double ringing_energy(const StringModel& model, const StringInput& input) {
  StringLayer layer(model, kStringRate, 1, 0);
  const auto sound = struck(layer, {1.2, 0.00101, 0.025, 1.0}, [&](double) { return input; });
  return energy_within(sound, 1.076, 1.176);  // the last blow falls at 0.976
}

}  // namespace rigsound::tests
