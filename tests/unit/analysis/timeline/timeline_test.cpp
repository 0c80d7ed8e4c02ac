// The picture of a render against the states it was drawn from.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "png_file.hpp"
#include "rigsound/analysis/timeline.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/session/state_table.hpp"
#include "temporary_folder.hpp"
#include "timeline/activity.hpp"
#include "timeline/level_picture.hpp"

using namespace rigsound;
using namespace rigsound::analysis;
using test::complaint;
using test::PngFile;

namespace {

constexpr int kRate = 48000;

// Idle, from 2 s normal, from 5 s overfeed, from 8 s idle.
constexpr const char* kStates =
    "time_s,signal,value\n"
    "0.000000,engine_rpm,1500\n"
    "0.000000,percussion,off\n"
    "2.000000,feed_pressure_bar,90\n"
    "2.000000,percussion,on\n"
    "5.000000,feed_pressure_bar,150\n"
    "8.000000,percussion,off\n";

std::vector<float> sine(double hz, double seconds) {
  std::vector<float> x;
  for (int n = 0; n < seconds * kRate; ++n)
    x.push_back(static_cast<float>(std::sin(2 * 3.14159265358979 * hz * n / kRate)));
  return x;
}

struct Render {
  test::TemporaryFolder folder;
  std::filesystem::path sound = folder.path / "a.wav", picture = folder.path / "a.png", states;

  explicit Render(const std::string& csv) : states(folder.write("a.csv", csv)) {
    write_wave(sound, sine(440, 10), kRate);
  }

  std::string complaint_of(const TimelineOptions& options = {}) const {
    return complaint([&] { write_timeline(picture, sound, states, options); });
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path), {}));
  }
};

/// Where the colour of a row of pixels changes, for good over a few pixels.
std::vector<int> edges(const PngFile& png, int row) {
  std::vector<int> found;
  for (int x = 1; x + 3 < png.width; ++x)
    if (png.at(x, row) != png.at(x - 1, row) && png.at(x, row) == png.at(x + 1, row) &&
        png.at(x, row) == png.at(x + 3, row))
      found.push_back(x);
  return found;
}

}  // namespace

TEST_CASE("the spans of the picture lie where the states change") {
  const Render render(kStates);
  REQUIRE(render.complaint_of() == "");
  const PngFile png = test::read_png(render.picture);
  REQUIRE(png.width == 1600);
  REQUIRE(png.height == 1000);
  constexpr int kRow = 81;  // in the strip of situations, above its letters
  const std::vector<int> at = edges(png, kRow);
  REQUIRE(at.size() == 5);  // left end, 2 s, 5 s, 8 s, right end
  const double left = at.front(), across = at.back() - at.front();
  CHECK(across > 1300);
  CHECK(std::fabs(at[1] - left - 0.2 * across) <= 1.5);
  CHECK(std::fabs(at[2] - left - 0.5 * across) <= 1.5);
  CHECK(std::fabs(at[3] - left - 0.8 * across) <= 1.5);
  const auto colour = [&](double seconds) {
    return png.at(static_cast<int>(left + across * seconds / 10), kRow);
  };
  CHECK(colour(1) == colour(9));
  CHECK(colour(1) != colour(3.5));
  CHECK(colour(3.5) != colour(6.5));
  CHECK(colour(3.5).green > colour(3.5).red);  // normal is green, overfeed is red
  CHECK(colour(6.5).red > colour(6.5).green + 50);
  // The name of the span stands in its middle.
  int letters = 0;
  for (int x = at[1]; x < at[2]; ++x) letters += png.at(x, kRow + 13).green < 90;
  CHECK(letters > 10);
}

TEST_CASE("the thresholds decide, and have the engine's hysteresis") {
  const Render render(kStates);
  const session::StateTable states = session::read_states(render.states);
  SceneOptions scene;
  const auto names = [&] {
    std::vector<Activity> found;
    for (const ActivitySpan& span : activity_spans(states, 0, scene, 10)) found.push_back(span.activity);
    return found;
  };
  using A = Activity;
  CHECK(names() == std::vector<A>{A::kIdle, A::kNormal, A::kOverfeed, A::kIdle});
  scene.overfeed_bar = 160;
  CHECK(names() == std::vector<A>{A::kIdle, A::kNormal, A::kIdle});
  scene.overfeed_bar = 148;  // the pressure of 150 has not passed 148 + 6 / 2
  CHECK(names() == std::vector<A>{A::kIdle, A::kNormal, A::kIdle});
  scene = {};
  scene.underfeed_bar = 100;
  CHECK(names() == std::vector<A>{A::kIdle, A::kUnderfeed, A::kOverfeed, A::kIdle});
}

TEST_CASE("rattling, a standing diesel and a second boom") {
  const Render render(
      "time_s,signal,value\n1,engine_rpm,800\n2,rattling,closed\n3,rattling,open\n4,rattling,none\n"
      "5,right.rattling,open\n9,engine_rpm,0\n");
  const session::StateTable states = session::read_states(render.states);
  REQUIRE(states.booms == std::vector<std::string>{"", "right"});
  const auto first = activity_spans(states, 0, {}, 10), second = activity_spans(states, 1, {}, 10);
  REQUIRE(first.size() == 6);
  CHECK(first[0].activity == Activity::kOff);
  CHECK(first[2].activity == Activity::kClosedRattling);
  CHECK(first[2].from_s == 2);
  CHECK(first[2].to_s == 3);
  CHECK(first[5].activity == Activity::kOff);
  CHECK(first[5].to_s == 10);
  REQUIRE(second.size() == 3);
  CHECK(second[2].activity == Activity::kOpenRattling);
  CHECK(render.complaint_of() == "");
}

TEST_CASE("rows of what follows from the signals, of controls and of manual marks are passed over") {
  const Render plain(kStates);
  const Render with(
      std::string(kStates) +
      "99,situation,overfeed\n99,left.feed_deviation,1.05\n99,decay_factor,2\n99,output_gain,0.5\n"
      "99,manual,engine_rpm left.rattling\n99,percussion,absent\n");
  const session::StateTable states = session::read_states(with.states);
  CHECK(states.booms == session::read_states(plain.states).booms);
  CHECK(states.changes.size() == session::read_states(plain.states).changes.size() + 1);
  CHECK(states.changes.back().value == info(Signal::kPercussion).absent);
}

TEST_CASE("a sine lies in the row of its frequency, with its level") {
  constexpr double kHz = 17.0 * kRate / 4096;  // in the middle of a bin, where rows are narrower than bins
  constexpr int kRows = 240;
  SoundFile sound{sine(kHz, 2), kRate, 1, 1};
  const LevelPicture levels = level_picture(sound, 50, kRows);
  CHECK(levels.highest_hz == 20000);
  const std::size_t width = 50, column = 25;
  std::size_t brightest = 0;
  for (std::size_t row = 0; row < kRows; ++row)
    if (levels.picture.pixels[row * width + column] > levels.picture.pixels[brightest * width + column])
      brightest = row;
  const double place = std::log(kHz / kLowestLevel_hz) / std::log(20000 / kLowestLevel_hz);
  CHECK(std::fabs(kRows * (1 - place) - static_cast<double>(brightest) - 0.5) < 2);
  const double level_db =
      levels.top_db - kLevelRange_db * (1 - levels.picture.pixels[brightest * width + column] / 255.0);
  CHECK(std::fabs(level_db) < 0.7);
}

TEST_CASE("a wrong states file is named with its line, and no picture is left") {
  const struct {
    const char *csv, *says;
  } cases[] = {
      {"time,signal,value\n", ":1: is no heading"},
      {"time_s,signal,value\n0,engine_rpm,800\n1,engine_rmp,900\n", ":3: signal: 'engine_rmp' is no signal"},
      {"time_s,signal,value\n0,engine_rpm,fast\n", ":2: engine_rpm: 'fast' is no value of it"},
      {"time_s,signal,value\n0,engine_rpm,9000\n",
       ":2: engine_rpm: '9000' is no value of it, expected 0...4000 r/min"},
      {"time_s,signal,value\n0,rattling,ajar\n",
       ":2: rattling: 'ajar' is no value of it, expected one of none|closed|open"},
      {"time_s,signal,value\n2,engine_rpm,800\n1,engine_rpm,900\n", ":3: time_s: falls back"},
      {"time_s,signal,value\nx,engine_rpm,800\n", ":2: time_s: 'x' is no number"},
      {"time_s,signal,value\n0,engine_rpm\n", ":2: '0,engine_rpm' is no row"},
      {"time_s,signal,value\n", "holds no row"},
      {"", "holds no row"},
  };
  for (const auto& c : cases) {
    CAPTURE(c.csv);
    const Render render(c.csv);
    const std::string said = render.complaint_of();
    CAPTURE(said);
    CHECK(said.find((render.states.string() + (c.says[0] == ':' ? "" : ": ") + c.says)) == 0);
    CHECK(render.files() == 2);
  }
}

TEST_CASE("an input is never written over, and what is no sound is refused") {
  const Render render(kStates);
  const std::string before = test::content(render.sound);
  CHECK(complaint([&] {
          write_timeline(render.sound, render.sound, render.states, {});
        }).find("is read as well as written") != std::string::npos);
  CHECK(complaint([&] {
          write_timeline(render.states, render.sound, render.states, {});
        }).find("is read as well as written") != std::string::npos);
  CHECK(test::content(render.sound) == before);
  CHECK(test::content(render.states) == kStates);
  CHECK(complaint([&] {
          write_timeline(render.picture, render.states, render.states, {});
        }).find("cannot be read") != std::string::npos);
  CHECK(complaint([&] { write_timeline(render.picture, "/nowhere.wav", render.states, {}); }) != "");
  CHECK(render.files() == 2);
}

TEST_CASE("a sound of a few samples and a long list of states still make a picture") {
  const Render render(kStates);
  write_wave(render.sound, std::vector<float>(10, 0.5f), kRate);
  TimelineOptions small;
  small.width = kMinTimelineWidth, small.height = kMinTimelineHeight;
  REQUIRE(render.complaint_of(small) == "");
  CHECK(test::read_png(render.picture).height == kMinTimelineHeight);
}
