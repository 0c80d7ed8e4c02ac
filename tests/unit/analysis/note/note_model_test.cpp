// The wavelet paper's note model, on a note whose spectrum is known.
#include "rigsound/analysis/note_model.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "analysis/noise.hpp"
#include "rigsound/analysis/rate.hpp"

using namespace rigsound::analysis;

namespace {

/// A pipe that is overblown: harmonics of 660 Hz with a tremolo, beside them wandering lines of the lower
/// mode at every half between and a hiss 25 dB under those.
std::vector<float> overblown_note() {
  constexpr double kF0 = 660;
  constexpr int kHarmonics = 9;
  TestNoise noise(5);
  std::vector<double> re(kHarmonics, 0.0), im(kHarmonics, 0.0);
  std::vector<float> x(static_cast<std::size_t>(1.2 * kAnalysisRate));
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t = static_cast<double>(n) / kAnalysisRate;
    double v = 2e-4 * noise.normal();
    for (int h = 1; h <= kHarmonics; ++h) {
      v += 0.3 / (h * h) * (1 + 0.05 * std::sin(2 * M_PI * 5 * t)) * std::sin(2 * M_PI * h * kF0 * t);
      const auto i = static_cast<std::size_t>(h - 1);
      constexpr double kWander = 1e-3;  // a sample: 8 Hz
      re[i] += std::sqrt(2 * kWander) * noise.normal() - kWander * re[i];
      im[i] += std::sqrt(2 * kWander) * noise.normal() - kWander * im[i];
      const double half = 2 * M_PI * (h - 0.5) * kF0 * t;
      v += 2e-3 / h * (re[i] * std::cos(half) + im[i] * std::sin(half));
    }
    x[n] = static_cast<float>(v);
  }
  return x;
}

}  // namespace

TEST_CASE("note model: independent subbands of an overblown pipe are not filled beside its harmonics") {
  const std::vector<float> x = overblown_note();
  NoteSettings settings;
  const NoteModel independent = model_note("note", x, settings);
  settings.one_over_f = true;
  const NoteModel law = model_note("note", x, settings);
  CHECK(independent.near_db < 1.5);
  CHECK(independent.near_db < law.near_db);
  CHECK(independent.at_db < 1);
  CHECK(independent.between_db < 1);
}
