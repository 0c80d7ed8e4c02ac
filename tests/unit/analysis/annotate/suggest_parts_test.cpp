#include "rigsound/analysis/suggestions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "simulate/situation_recording.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

constexpr double kTolerance_s = 0.25;
constexpr int kRate = static_cast<int>(kAnalysisRate);

/// A shift: pieces of simulated drilling and of the diesel alone, cut together.
struct Shift {
  std::vector<float> sound;
  std::vector<double> borders_s;
};

void append(Shift& shift, const std::vector<double>& clean, const std::vector<double>& background,
            double from_s, double seconds) {
  if (!shift.sound.empty()) shift.borders_s.push_back(static_cast<double>(shift.sound.size()) / kRate);
  const auto from = static_cast<std::size_t>(from_s * kRate),
             count = static_cast<std::size_t>(seconds * kRate);
  for (std::size_t n = from; n < from + count; ++n)
    shift.sound.push_back(static_cast<float>((clean.empty() ? 0 : clean[n]) + background[n]));
}

Shift simulated_shift(std::uint64_t seed) {
  constexpr double kTake_s = 9;
  std::vector<SituationRecording> takes;
  for (const Situation s :
       {Situation::kNormal, Situation::kUnderfeed, Situation::kOverfeed, Situation::kClosedRattling})
    takes.push_back(simulate_situation(s, seed, kTake_s));
  SplitMix chance(seed * 7919);
  Shift shift;
  std::size_t before = 99;
  for (int piece = 0; piece < 14; ++piece) {
    std::size_t next = before;
    while (next == before) next = static_cast<std::size_t>(chance.uniform(0, 4.999));  // 4: the diesel alone
    const double seconds = chance.uniform(2, 5), from = chance.uniform(1.2, kTake_s - 1.2 - seconds);
    if (next == 4)
      append(shift, {}, takes[0].background, from, seconds);
    else
      append(shift, takes[next].clean, takes[next].background, from, seconds);
    before = next;
  }
  return shift;
}

std::vector<SuggestedPart> suggested(const std::vector<float>& sound) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "shift.wav";
  write_wave(file, sound, kRate);
  SoundReader reader(file);
  return suggest_parts(reader);
}

}  // namespace

TEST_CASE("the borders of simulated shifts are found, and no others") {
  int found = 0, missed = 0, wrong = 0;
  for (const std::uint64_t seed : {101, 102, 103, 104}) {  // the method was settled on others
    const Shift shift = simulated_shift(seed);
    const std::vector<SuggestedPart> parts = suggested(shift.sound);
    std::vector<double> told;
    for (std::size_t i = 1; i < parts.size(); ++i) told.push_back(parts[i].start_s);
    for (const double border : shift.borders_s) {
      const auto nearest = std::find_if(told.begin(), told.end(),
                                        [&](double t) { return std::fabs(t - border) <= kTolerance_s; });
      nearest == told.end() ? ++missed : ++found;
      if (nearest != told.end()) told.erase(nearest);
    }
    wrong += static_cast<int>(told.size());
  }
  const double f = 2.0 * found / (2.0 * found + missed + wrong);
  MESSAGE("F " << f << ": " << found << " found, " << missed << " missed, " << wrong << " wrong");
  CHECK(f >= 0.95);
}

TEST_CASE("parts cover the recording, and a recording without a change is one part") {
  const SituationRecording take = simulate_situation(Situation::kNormal, 105, 12);
  Shift shift;
  append(shift, take.clean, take.background, 1.5, 9);
  const std::vector<SuggestedPart> parts = suggested(shift.sound);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].start_s == 0);
  CHECK(parts[0].end_s == doctest::Approx(9));
  CHECK(parts[0].rate_hz == doctest::Approx(take.rate_hz).epsilon(0.05));
  CHECK(parts[0].rhythmic > 0.8);
}

TEST_CASE("a step of level alone is told as one") {
  const SituationRecording take = simulate_situation(Situation::kNormal, 106, 14);
  Shift shift;
  append(shift, take.clean, take.background, 1.5, 11);
  for (std::size_t n = 5 * kRate; n < shift.sound.size(); ++n) shift.sound[n] *= 2;
  const std::vector<SuggestedPart> parts = suggested(shift.sound);
  REQUIRE(parts.size() == 2);
  CHECK(std::fabs(parts[1].start_s - 5) <= kTolerance_s);
  CHECK(parts[1].level_changed);
  CHECK_FALSE(parts[1].spectrum_changed);
  CHECK_FALSE(parts[1].rate_changed);
  CHECK(parts[1].level_db - parts[0].level_db == doctest::Approx(6).epsilon(0.2));
}

TEST_CASE("silence and a sound shorter than a part are one part") {
  CHECK(suggested(std::vector<float>(3 * kRate, 0.0F)).size() == 1);
  CHECK(suggested(std::vector<float>(kRate / 50, 0.1F)).size() == 1);
}
