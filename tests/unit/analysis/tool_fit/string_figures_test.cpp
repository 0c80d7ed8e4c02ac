// Figures of a drill string against closed forms.
#include "rigsound/analysis/string_figures.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

StringModel rods(int count) {
  StringModel model;
  model.rods = count;
  return model;
}

}  // namespace

TEST_CASE("rods end to end are a comb of m c / 2 N L; bent, the first mode of 3.66 m is at 13 Hz") {
  const StringFigures f = string_figures(rods(6), 3.66, 2e8, 48000);
  REQUIRE(f.rods.size() == 50);
  for (const StringMode& mode : f.rods) {
    CHECK(mode.target_hz == doctest::Approx(mode.mode * 5200 / (2 * 6 * 3.66)).epsilon(1e-6));
    CHECK(std::fabs(1200 * std::log2(mode.model_hz / mode.target_hz)) < 2);
  }
  CHECK(f.bending.front().target_hz == doctest::Approx(13).epsilon(0.03));
  CHECK(f.string.front().target_hz < f.rods.front().target_hz);  // the shank makes it longer
}

TEST_CASE("a pressed string rings for less time than a free one") {
  const StringModel model = rods(3);
  const StringFigures f = string_figures(model, 2, 2e8, 48000);
  for (const auto* family : {&f.string, &f.bending})
    for (const StringMode& mode : *family) CHECK(mode.t60_pressed_s < mode.t60_s);
  CHECK(f.string.front().t60_pressed_s < model.guided_s);
  CHECK(f.string.front().t60_pressed_s > 0.8 * model.guided_s);
}

TEST_CASE("the bit sends back what a spring that unloads stiffly does, whatever the rock") {
  for (const double stiffness : {5e7, 2e8, 5e8}) {
    const StringFigures f = string_figures(rods(1), 3.66, stiffness, 48000);
    const double Z = M_PI / 4 * 0.038 * 0.038 * 7850 * 5200;
    CHECK(f.loading_s == doctest::Approx(Z / stiffness));
    for (const ReflectionRow& row : f.reflection) {
      const double x = row.pulse_s * stiffness / Z;
      CHECK(row.x == doctest::Approx(x));
      const double r = 1 - 4 * (1 - std::exp(-x)) / x + 2 * (1 - std::exp(-2 * x)) / x;
      CHECK(row.target == doctest::Approx(r));
      if (row.pulse_s > 8.5 / 48000 && x >= 0.25 && x <= 3)
        CHECK(row.reached.energy == doctest::Approx(r).epsilon(0.01));
      if (row.pulse_s > 8.5 / 48000)
        CHECK(row.reached.force == doctest::Approx(2 * (1 - std::exp(-x))).epsilon(0.05));
    }
  }
}

TEST_CASE("a blow sends back about what a rectangular pulse of its impulse and energy does") {
  for (const double stiffness : {1e8, 2e8, 5e8}) {
    const StringFigures f = string_figures(rods(1), 3.66, stiffness, 96000);
    CHECK(f.blow.energy == doctest::Approx(reflected_energy(f.blow_x)).epsilon(0.25));
  }
}

TEST_CASE("a rock is that of the sound set, else one of the usual ones, else named with what there is") {
  CHECK(config::find_rock("", "hard").stiffness > config::find_rock("", "soft").stiffness);
  CHECK(config::find_rock("", "medium").stiffness == Rock().stiffness);
  const test::TemporaryFolder folder;
  config::SoundSetIndex index;
  index.rocks = {{"gneiss", 3e8}, {"soft", 7e7}};
  config::merge_index(folder.path, index);
  CHECK(config::find_rock(folder.path, "gneiss").stiffness == 3e8);
  CHECK(config::find_rock(folder.path, "soft").stiffness == 7e7);
  const std::string complaint = test::complaint([] { config::find_rock("", "hadr"); });
  CHECK(complaint.find("expected medium, soft, hard, hardest; did you mean hard?") != std::string::npos);
}

TEST_CASE("the picture shows every mode") {
  const StringFigures f = string_figures(rods(1), 3.66, 2e8, 48000);
  const std::string svg = string_plot_svg("a <string>", "rock \"medium\"", f);
  CHECK(svg.find("a &lt;string&gt;") != std::string::npos);
  std::size_t dots = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1))
    ++dots;
  CHECK(dots == f.rods.size() + f.string.size() + f.bending.size() + f.reflection.size() + 1);
}
