// The designer: how near, how small, how it decays, what it refuses.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include "rigsound/dsp/random.hpp"
#include "rigsound/tool_model.hpp"

using namespace rigsound;

namespace {

std::string complaint(const ToolModel& model, double rate = 48000) {
  try {
    design_tool(model, rate);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

template <class Change>
std::string complaint_after(Change change, double rate = 48000) {
  ToolModel model;
  change(model);
  return complaint(model, rate);
}

bool begins_with(const std::string& text, const std::string& beginning) {
  return text.rfind(beginning, 0) == 0;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("random bars are tuned to within a third of a cent, within the order and delay they may have") {
  const dsp::RandomField random(11, 4);
  for (std::uint64_t i = 0; i < 24; ++i)
    for (const double rate : {44100.0, 48000.0, 96000.0}) {
      ToolModel model;
      model.bar = {0.3 + 0.7 * random.uniform(i, 0), 0.015 + 0.035 * random.uniform(i, 1)};
      const ToolDesign design = design_tool(model, rate);
      CHECK(design.transversal.allpass.order() <= 30);
      CHECK(design.longitudinal.allpass.order() <= 5);
      CHECK(design.transversal.delay_samples >= design.transversal.allpass.stages());
      CHECK(design.longitudinal.delay_samples >= design.longitudinal.allpass.stages());
      for (const TunedMode& mode : tuned_modes(model, design))
        CHECK(std::fabs(mode.error_cents) <= (mode.family == "transversal" ? 0.3 : 1.0));
    }
}

TEST_CASE("a bar so short that it stretches in one mode only is tuned all the same") {
  ToolModel model;
  model.bar = {0.25, 0.015};
  int stretching = 0;
  for (const TunedMode& mode : tuned_modes(model, design_tool(model, 48000))) {
    CHECK(std::fabs(mode.error_cents) <= 1);
    if (mode.family == "transversal") continue;
    ++stretching;
    CHECK(mode.target_hz == doctest::Approx(5200 / (2 * 0.25)).epsilon(0.001));
  }
  CHECK(stretching == 1);
}

TEST_CASE("two wanted decay times are met within 0.1 %, and the modes stay where they were") {
  struct Case {
    Bar bar;
    int low, high;  // modes
    double low_s, high_s, rate;
  };
  for (const Case& c :
       {Case{{0.5, 0.025}, 1, 5, 0.5, 0.1, 48000}, Case{{0.5, 0.025}, 1, 8, 0.2, 0.02, 44100},
        Case{{0.3, 0.03}, 1, 4, 0.3, 0.08, 96000}, Case{{0.7, 0.03}, 2, 9, 1.0, 0.2, 48000}}) {
    ToolModel model;
    model.bar = c.bar;
    const auto targets = tuned_modes(model, design_tool(model, c.rate));
    const auto hz = [&](int mode) { return targets[static_cast<std::size_t>(mode - 1)].target_hz; };
    model.transversal.wish = {hz(c.low), c.low_s, hz(c.high), c.high_s};
    const auto modes = tuned_modes(model, design_tool(model, c.rate));
    CHECK(modes[static_cast<std::size_t>(c.low - 1)].t60_s == doctest::Approx(c.low_s).epsilon(0.001));
    CHECK(modes[static_cast<std::size_t>(c.high - 1)].t60_s == doctest::Approx(c.high_s).epsilon(0.001));
    for (const TunedMode& mode : modes) CHECK(std::fabs(mode.error_cents) <= 1);
  }
}

TEST_CASE("a wish that cannot be granted is answered with what can") {
  ToolModel model;
  model.transversal.wish = {460, 0.1, 5000, 0.5};
  const std::string text = complaint(model);
  double shortest = 0, longest = 0;
  REQUIRE(std::sscanf(text.c_str(), "t60: no passive loop decays like that, expected %lf ms...%lf ms",
                      &shortest, &longest) == 2);
  CHECK(shortest < longest);
  CHECK(text.substr(text.find(" at ")) == " at 5000 Hz beside 100.0 ms at 460 Hz");
  shortest /= 1000, longest /= 1000;
  for (const double high_s : {shortest, longest}) {
    model.transversal.wish.high_s = high_s;
    CHECK(complaint(model).empty());
  }
  for (const double high_s : {0.9 * shortest, 1.1 * longest}) {
    model.transversal.wish.high_s = high_s;
    CHECK(begins_with(complaint(model), "t60: no passive loop"));
  }
}

TEST_CASE("a decay that only a loop without losses has is refused, the longest that is told is granted") {
  ToolModel model;
  model.transversal.wish = {460, 30, 5000, 29};
  const std::string text = complaint(model),
                    told = "t60: 30000.0 ms at 460 Hz is too long, expected at most ";
  REQUIRE(begins_with(text, told));
  const double longest_s = std::atof(text.c_str() + told.size()) / 1000;
  model.transversal.wish.low_s = longest_s;
  double shortest = 0, longest = 0;
  REQUIRE(std::sscanf(complaint(model).c_str(),
                      "t60: no passive loop decays like that, expected %lf ms...%lf ms", &shortest,
                      &longest) == 2);
  model.transversal.wish.high_s = (shortest + longest) / 2000;
  CHECK(complaint(model).empty());
  model.transversal.wish.low_s = 1.05 * longest_s;  // k lies between 0.9999 and 1
  CHECK(begins_with(complaint(model), "t60: "));
}

TEST_CASE("a wish names two frequencies a tenth apart at least, up to 0.41 of the rate") {
  const auto told = [](double low_hz, double high_hz) {
    return complaint_after([&](ToolModel& m) { m.transversal.wish = {low_hz, 0.1, high_hz, 0.1}; });
  };
  CHECK(told(1000, 1099).find("too close together, expected high_hz at least 1.1 low_hz") !=
        std::string::npos);
  CHECK(told(1000, 900).find("too close together") != std::string::npos);
  CHECK(told(1000, 1101).find("too close together") == std::string::npos);
  CHECK(told(1000, 19690).find("t60.high_hz: is 19690, expected at most 0.41 of the sample rate, 19680") !=
        std::string::npos);
  CHECK(told(1000, 19670).find("t60.high_hz") == std::string::npos);
}

TEST_CASE("each of a wish's four numbers is needed, and none of them where there is no wish") {
  for (int missing = 0; missing < 4; ++missing) {
    double wish[] = {460, 0.5, 5000, 0.1};
    wish[missing] = 0;
    CAPTURE(missing);
    CHECK(begins_with(complaint_after([&](ToolModel& m) {
                        m.transversal.wish = {wish[0], wish[1], wish[2], wish[3]};
                      }),
                      "transversal.t60: is given in part"));
  }
  CHECK(complaint_after([](ToolModel& m) { m.transversal.wish = {460, 0, 5000, 0}; }).empty());
}

TEST_CASE("a design made ahead of time is taken as it is, at its own rate and for its own bar only") {
  ToolModel model;
  ToolDesign ready = design_tool(model, 48000);
  ready.transversal.reflection_max = 0.88;
  model.designs = {ready};
  CHECK(design_for(model, 48000).transversal.reflection_max == 0.88);
  CHECK(design_for(model, 44100).transversal.reflection_max == 0.89);
  ToolModel longer = model, livelier = model;
  longer.bar.length_m = 0.51;
  livelier.longitudinal.reflection_max = 0.95;
  CHECK(design_for(longer, 48000).transversal.reflection_max == 0.89);
  CHECK(design_for(livelier, 48000).longitudinal.reflection_max == 0.95);
  model.designs[0].transversal.delay_samples = 2;
  CHECK_THROWS_AS(design_for(model, 48000), std::invalid_argument);
}

TEST_CASE("the paper's own loops are nearly harmonic, far from the bar") {
  ToolModel model;
  model.kind = ToolKind::kPaper;
  model.paper = {20, -0.618, 10, 8};
  const auto modes = tuned_modes(model, design_tool(model, 44100));
  REQUIRE(modes.size() >= 4);
  CHECK(modes[0].model_hz == doctest::Approx(468).epsilon(0.02));
  CHECK(modes[1].model_hz / modes[0].model_hz == doctest::Approx(2.03).epsilon(0.01));
  CHECK(modes[2].model_hz / modes[0].model_hz == doctest::Approx(3.14).epsilon(0.01));
  CHECK(modes[3].model_hz / modes[0].model_hz == doctest::Approx(4.36).epsilon(0.01));
}

TEST_CASE("nonsense is refused when the tool is built") {
  CHECK(complaint(ToolModel{}).empty());
  for (const double length : {0.0, -1.0, 100.0, kNan, std::numeric_limits<double>::infinity()})
    CHECK(begins_with(complaint_after([&](ToolModel& m) { m.bar.length_m = length; }), "length_m: "));
  for (const double diameter : {0.0, 0.6, kNan})
    CHECK(begins_with(complaint_after([&](ToolModel& m) { m.bar.diameter_m = diameter; }), "diameter_m: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) {
                      m.bar = {0.21, 0.075};
                    }),
                    "diameter_m: is 0.075 m, too thick"));
  for (const double rate : {0.0, -48000.0, kNan, 1e9})
    CHECK(begins_with(complaint(ToolModel{}, rate), "rate: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.transversal.reflection_max = 1; }),
                    "transversal.k_max: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.transversal.reflection_min = 0.95; }),
                    "transversal.k_min: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.strike.bounces = 5; }), "strike.bounces: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.strike.width_s = 0; }), "strike.width_s: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.voicing.highpass_hz = kNan; }),
                    "voicing.highpass_hz: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.voicing.equaliser.resize(7); }),
                    "voicing.equaliser: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.rods = {{2, {0, 0.02}}}; }), "rods[0].length_m: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) {
                      m.transversal.wish = {460, 0.1, 5000, 0.5};
                    }),
                    "t60: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) {
                      m.transversal.wish = {460, kNan, 5000, 0.5};
                    }),
                    "transversal.t60.low_s: "));
  CHECK(begins_with(complaint_after([](ToolModel& m) {
                      m.transversal.wish = {460, 0, 5000, 0.5};
                    }),
                    "transversal.t60: is given in part"));
  CHECK(begins_with(complaint_after([](ToolModel& m) { m.kind = ToolKind::kPaper, m.paper.M = 65; }),
                    "paper.M: "));
}
