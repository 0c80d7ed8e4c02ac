// The picture of a diesel: how large it is, and what can be seen in it.
#include "rigsound/analysis/background_plot.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "rigsound/default_diesel.hpp"
#include "simulate/diesel_recording.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a diesel of many speeds is drawn in 0.2 MB, recorded and modelled apart" *
          doctest::test_suite("long")) {
  constexpr std::size_t kSpeeds = 13, kRows = 12, kOctaves = 6;
  DieselModel model = default_diesel();
  model.points.resize(1);
  std::vector<DieselTake> takes;
  for (std::size_t i = 0; i < kSpeeds; ++i) {
    DieselRun run;
    DieselTake take;
    take.rpm = 1000 + 100 * static_cast<double>(i);
    run.rpm = steady_rpm(take.rpm, 3);
    const DieselRecording recording = simulate_diesel(run);
    take.source = "take.wav", take.mono.assign(recording.sound.begin(), recording.sound.end());
    takes.push_back(take);
    if (i > 0) model.points.push_back(model.points.front());
    model.points.back().rpm = take.rpm;
  }
  const test::TemporaryFolder folder;
  write_background_plot(folder.path / "diesel.svg", takes, model);
  std::ifstream file(folder.path / "diesel.svg");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string svg = text.str();
  CHECK(svg.size() <= 200000);
  CHECK(svg.find("12 of 13 speeds") != std::string::npos);
  for (const char* end : {"1000 r/min", "2200 r/min"}) CHECK(svg.find(end) != std::string::npos);
  // The recorded curve is the wider one and lies under the modelled one.
  CHECK(count(svg, "<path class=\"ssecond\" stroke-width=\"3\"") == kRows * (1 + kOctaves));
  CHECK(count(svg, "<path class=\"sthird\"") == kRows * (1 + kOctaves));
  CHECK(svg.find("class=\"ssecond\"") < svg.find("class=\"sthird\""));
}
