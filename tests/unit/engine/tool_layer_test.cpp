// The tool layer as a whole: its strikes, its contact, its sameness across rates, its live changes.
#include "tool/tool_layer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "engine/allocation_guard.hpp"

using namespace rigsound;
using namespace rigsound::tool;

namespace {

ToolModel plain_model() {
  ToolModel model;
  model.strike.amplitude_variation = 0;
  model.strike.bounces = 0;
  model.strike.slope_variation = 0;
  return model;
}

/// `seconds` of the layer, struck every `period_s` from `first_s` on; `controls(t)` is asked once a chunk.
template <class Controls>
std::vector<double> rendered(ToolLayer& layer, double rate, double seconds, double first_s, double period_s,
                             Controls controls) {
  std::vector<double> sound;
  double next = first_s * rate;
  std::uint64_t index = 0;
  for (double start = 0; start < seconds * rate; start += kChunk) {
    Impact blow;
    int count = 0;
    if (next < start + kChunk) blow = {next - start, 1, index++}, count = 1, next += period_s * rate;
    double out[kChunk];
    ToolControls c = controls(start / rate);
    c.period = period_s * rate;
    layer.process(&blow, count, c, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  return sound;
}

std::vector<double> one_blow(double rate, const ToolModel& model) {
  ToolLayer layer(model, rate, 1, 0);
  return rendered(layer, rate, 0.5, 0.00101, 100, [](double) { return ToolControls{}; });
}

std::vector<std::complex<double>> spectrum(std::vector<double> x) {
  std::vector<std::complex<double>> X;
  Eigen::FFT<double>().fwd(X, x);
  return X;
}

/// Energy per third of an octave around `centre`, as if the sound were continuous in time.
double band_db(const std::vector<std::complex<double>>& X, double rate, double centre) {
  const double hz = rate / static_cast<double>(X.size());
  double sum = 0;
  for (std::size_t k = 1; k < X.size() / 2; ++k) {
    const double f = hz * static_cast<double>(k);
    if (f >= centre * std::pow(2, -1.0 / 6) && f < centre * std::pow(2, 1.0 / 6))
      sum += std::norm(X[k]) / (rate * rate) * hz;
  }
  return 10 * std::log10(sum);
}

/// Peak of what lies above 12 kHz within `from_s`...`to_s` against the peak of the whole sound, dB: a
/// linear-phase high-pass of 513 taps under a Blackman-Harris window.
double residue_db(const std::vector<double>& sound, double rate, double from_s, double to_s) {
  constexpr int kHalf = 256;
  std::vector<double> taps;
  for (int i = -kHalf; i <= kHalf; ++i) {
    const double t = M_PI * i / (kHalf + 1), cut = 2 * 12000 / rate;
    const double window =
        0.35875 + 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) + 0.01168 * std::cos(3 * t);
    const double low = i == 0 ? cut : std::sin(M_PI * cut * i) / (M_PI * i);
    taps.push_back(window * ((i == 0) - low));
  }
  double peak = 0, high_peak = 0;
  for (const double x : sound) peak = std::max(peak, std::fabs(x));
  for (auto n = static_cast<int>(from_s * rate); n < static_cast<int>(to_s * rate); ++n) {
    double sum = 0;
    for (int i = -kHalf; i <= kHalf; ++i)
      sum += taps[static_cast<std::size_t>(i + kHalf)] * sound[static_cast<std::size_t>(n - i)];
    high_peak = std::max(high_peak, std::fabs(sum));
  }
  return 20 * std::log10(high_peak / peak);
}

/// A bar whose low modes ring for seconds, so that a change meets it in full voice.
ToolModel long_ringing_model() {
  ToolModel model = plain_model();
  model.strike.width_s = 0.001;
  model.transversal.k_min = 0.998, model.transversal.k_max = 0.999;
  model.longitudinal.k_min = model.longitudinal.k_max = 0.999;
  model.rods = {{2, {0.55, 0.025}}};
  return model;
}

}  // namespace

TEST_CASE("a blow is a Hann pulse that begins between samples") {
  Strike strike = plain_model().strike;
  Strikes strikes(strike, 48000, 1, 0);
  const Impact blow{29.25, 2, 0};
  double x[2 * kChunk];
  CHECK(strikes.process(&blow, 1, 2400, x));
  CHECK(strikes.process(nullptr, 0, 2400, x + kChunk));
  const double width = strike.width_s * 48000;
  for (int n = 0; n < 2 * kChunk; ++n) {
    const double t = n - 29.25;
    const double pulse = t >= 0 && t < width ? 1 - std::cos(2 * M_PI * t / width) : 0;
    CHECK(x[n] == doctest::Approx(pulse).epsilon(1e-12));
  }
  CHECK_FALSE(strikes.process(nullptr, 0, 2400, x));
}

TEST_CASE("bounces follow one another by 5 to 10 % of the period, each weaker than the last") {
  Strike strike;
  Strikes strikes(strike, 48000, 5, 0);
  const double period = 4000;
  double lowest = 1, highest = 0, first = 0;
  int touches = 0, amplitudes_in_range = 0;
  for (std::uint64_t blow = 0; blow < 300; ++blow) {
    double x[kChunk], last = 0;
    for (int chunk = 0; chunk < 125; ++chunk) {
      const Impact impact{0, 1, blow};
      strikes.process(&impact, chunk == 0, period, x);
      for (const Touch& touch : strikes) {
        const double at = chunk * kChunk + touch.at;
        if (at > 0)
          lowest = std::min(lowest, (at - last) / period), highest = std::max(highest, (at - last) / period);
        last = at;
        ++touches;
        CHECK(std::fabs(touch.slope - 1) <= strike.slope_variation);
      }
      if (chunk == 0) first = *std::max_element(x, x + kChunk);
    }
    amplitudes_in_range += first > 0.78 && first <= 1.2;
  }
  CHECK(touches == 300 * (1 + strike.bounces));
  CHECK(lowest >= 0.05 - 1 / period);
  CHECK(lowest < 0.055);
  CHECK(highest <= 0.10 + 1 / period);
  CHECK(highest > 0.095);
  CHECK(amplitudes_in_range == 300);
}

TEST_CASE("k_T falls from where it is at each touch and rises after, never faster than its slopes") {
  LoopDesign loop;
  loop.k_min = 0.83, loop.k_max = 0.89;
  Strike strike = plain_model().strike;
  strike.bounces = 4;
  Strikes strikes(strike, 48000, 1, 0);
  Contact contact(loop, strike, 48000);
  double before = 0.89, lowest = 1;
  for (int chunk = 0; chunk < 400; ++chunk) {
    const Impact blow{7.5, 1, static_cast<std::uint64_t>(chunk)};
    double x[kChunk], k_T[kChunk];
    strikes.process(&blow, chunk % 80 == 0, 2560, x);
    contact.process(strikes, k_T);
    for (const double k : k_T) {
      CHECK(k - before <= 0.06 / (0.010 * 48000) + 1e-12);
      CHECK(before - k <= 0.06 / (0.002 * 48000) + 1e-12);
      CHECK(k >= 0.83);
      CHECK(k <= 0.89);
      before = k;
      lowest = std::min(lowest, k);
    }
  }
  CHECK(lowest == 0.83);
}

TEST_CASE("one blow sounds the same at 44.1, 48 and 96 kHz") {
  for (const Bar bar : {Bar{0.3, 0.03}, Bar{0.5, 0.025}, Bar{0.7, 0.03}}) {
    ToolModel model = plain_model();
    model.bar = bar;
    const auto low = spectrum(one_blow(44100, model));
    const auto mid = spectrum(one_blow(48000, model));
    const auto high = spectrum(one_blow(96000, model));
    double worst = 0;
    for (double centre = 125; centre < 15000; centre *= std::pow(2, 1.0 / 3)) {
      const double a = band_db(low, 44100, centre), b = band_db(mid, 48000, centre),
                   c = band_db(high, 96000, centre);
      worst = std::max(worst, std::max({a, b, c}) - std::min({a, b, c}));
    }
    MESSAGE("third-octave difference " << worst << " dB");
    CHECK(worst <= 0.6);
  }
}

TEST_CASE("live changes leave nothing above 12 kHz") {
  const double rate = 48000, change_s = 0.5;
  const auto residue = [&](auto change) {
    ToolLayer layer(long_ringing_model(), rate, 1, 0);
    const auto sound = rendered(layer, rate, 0.7, 0.1, 100, [&](double t) {
      ToolControls controls;
      if (t >= change_s) change(controls);
      return controls;
    });
    return residue_db(sound, rate, change_s - 0.01, change_s + 0.05);
  };
  const double floor = residue([](ToolControls&) {});
  const double steel = residue([](ToolControls& c) { c.rods = 2; });
  const double reflection = residue([](ToolControls& c) { c.k_T = 0.93, c.k_L = 0.95; });
  const double gains = residue([](ToolControls& c) { c.mix_T = 0.3, c.mix_L = 2; });
  MESSAGE("residue above 12 kHz: nothing changed " << floor << ", steel " << steel << ", k " << reflection
                                                   << ", gains " << gains << " dB");
  CHECK(floor <= -110);
  CHECK(steel <= -100);
  CHECK(reflection <= -90);
  CHECK(gains <= -90);
}

TEST_CASE("the layer repeats itself bit for bit, differs between booms, and never allocates") {
  ToolModel model;
  model.rods = {{3, {0.7, 0.03}}};
  model.voicing.equaliser = {{2000, -4, 1.4}};
  const auto controls = [](double t) {
    ToolControls c;
    c.rods = t > 0.2 ? 3 : 1;
    return c;
  };
  ToolLayer first(model, 48000, 9, 0), again(model, 48000, 9, 0), other(model, 48000, 9, 1);
  ToolLayer narrow(model, 48000, 9, 0, LaneWidth::kTwo);
  const auto sound = rendered(first, 48000, 0.5, 0.01, 0.03, controls);
  CHECK(rendered(again, 48000, 0.5, 0.01, 0.03, controls) == sound);
  CHECK(rendered(narrow, 48000, 0.5, 0.01, 0.03, controls) == sound);
  CHECK(rendered(other, 48000, 0.5, 0.01, 0.03, controls) != sound);
  double out[kChunk];
  const long before = tests::allocations();
  for (int chunk = 0; chunk < 500; ++chunk) {
    const Impact blow{1.5, 1, static_cast<std::uint64_t>(chunk)};
    first.process(&blow, chunk % 40 == 0, controls(chunk > 250 ? 0 : 1), out);
  }
  CHECK(tests::allocations() == before);
}
