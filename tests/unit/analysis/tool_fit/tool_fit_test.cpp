// An impact on a known steel: are its size, its decays and its spectrum found again?
#include "rigsound/analysis/tool_fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/random.hpp"
#include "rigsound/machine/input_error.hpp"
#include "tool_fit/impact_sound.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

/// A fifth of a second of noise 60 dB below the peak, then the impact in it.
Recording recorded(const ToolModel& model) {
  Recording recording;
  recording.source_rate = static_cast<int>(kAnalysisRate);
  const dsp::RandomField random(4, 4);
  const auto impact = one_impact(model, static_cast<std::size_t>(0.3 * kAnalysisRate));
  double peak = 0;
  for (const double x : impact) peak = std::max(peak, std::fabs(x));
  const auto before = static_cast<std::size_t>(0.2 * kAnalysisRate);
  for (std::size_t n = 0; n < before + impact.size(); ++n) {
    const double sound = n < before ? 0 : impact[n - before] / peak;
    recording.mono.push_back(static_cast<float>(0.5 * (sound + 0.0003 * random.normal(n, 0))));
  }
  return recording;
}

}  // namespace

TEST_CASE("length, diameter, decays and spectrum of a known steel are found in its recorded impact" *
          doctest::test_suite("long")) {
  ToolModel truth;
  truth.bar = {0.5, 0.025};
  truth.transversal.reflection_min = 0.95, truth.transversal.reflection_max = 0.98,
  truth.transversal.shelf_gain = 0.9;
  truth.longitudinal.reflection_min = truth.longitudinal.reflection_max = 0.98;
  const ToolFit fit = fit_tool(recorded(truth), "impact.wav", {});
  CHECK(fit.estimated);
  CHECK(fit.model.bar.length_m == doctest::Approx(0.5).epsilon(0.03));
  CHECK(fit.model.bar.diameter_m == doctest::Approx(0.025).epsilon(0.06));
  CHECK(fit.mean_error_db < 1.5);
  const auto wanted = tuned_modes(truth, design_tool(truth, kAnalysisRate));
  const auto found = tuned_modes(fit.model, design_tool(fit.model, kAnalysisRate));
  for (std::size_t i = 0; i < 5; ++i) CHECK(found[i].t60_s == doctest::Approx(wanted[i].t60_s).epsilon(0.10));
}

TEST_CASE("a sound without clear modes says so") {
  Recording noise;
  noise.source_rate = static_cast<int>(kAnalysisRate);
  const dsp::RandomField random(4, 5);
  for (std::size_t n = 0; n < 24000; ++n) {
    const double t = (static_cast<double>(n) - 12000) / kAnalysisRate;
    const double envelope = t < 0 ? 0.0001 : std::exp(-t / 0.02);
    noise.mono.push_back(static_cast<float>(0.2 * envelope * random.normal(n, 0)));
  }
  CHECK_THROWS_AS(fit_tool(noise, "noise.wav", {}), InputError);
}
