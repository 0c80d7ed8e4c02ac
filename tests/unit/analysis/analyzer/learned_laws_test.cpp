// What a ramp recorded at +6 dB teaches: rate, level and decay at feeds that no bank was recorded at.
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/analyzer/analyzer_workplace.hpp"
#include "analysis/analyzer/learned_drill.hpp"
#include "rigsound/config/sound_set_index.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

TEST_CASE("a feed ramp at +6 dB gives a series and its laws, right between its banks and beyond them" *
          doctest::test_suite("long")) {
  for (const std::uint64_t seed : {11, 12, 13}) {
    const Workplace at;
    const SoundSet sounds = learned_from_ramp(at / "", {seed, 48, 2});
    const DrillingLaws truth(seed);
    REQUIRE(sounds.laws.size() == 1);
    const FeedLaws &laws = sounds.laws[0], wanted = DrillingLaws::slopes();
    CHECK(laws.rods == 1);
    CHECK(laws.rock == -1);
    CHECK(laws.ln_gap == doctest::Approx(wanted.ln_gap).epsilon(0.1));
    CHECK(laws.ln_level == doctest::Approx(wanted.ln_level).epsilon(0.15));
    CHECK(laws.ln_decay == doctest::Approx(wanted.ln_decay).epsilon(0.1));
    CHECK(laws.tilt_db_per_octave == doctest::Approx(wanted.tilt_db_per_octave).epsilon(0.2));
    CHECK(sounds.uses.size() >= 12);
    for (std::size_t i = 0; i + 1 < sounds.uses.size(); ++i)
      CHECK(sounds.uses[i].feed_bar < sounds.uses[i + 1].feed_bar);
    // Half-way between the banks, and up to 40 bar beyond the last one.
    std::vector<double> feeds = {20, 28, 175, 190, 200};
    for (std::size_t i = 0; i + 1 < sounds.uses.size(); ++i)
      feeds.push_back(0.5 * (sounds.uses[i].feed_bar + sounds.uses[i + 1].feed_bar));
    for (const double feed : feeds) {
      const HeardErrors errors = errors_at(sounds, truth, feed);
      INFO("seed ", seed, ", ", feed, " bar");
      CHECK(std::fabs(errors.rate) < 0.01);
      CHECK(std::fabs(errors.level_db) < 0.5);
      CHECK(std::fabs(errors.decay) < 0.1);
    }
  }
}

TEST_CASE("laws are written once: by a run over all parts, and never over what people wrote") {
  const Workplace at;
  write_recordings(at);
  write_clip(at / "in/three.wav", 103, 6.3);
  write_text(at / "in/three.txt",
             "0.0\t2.0\tunderfeed rods=2 feed=40\n2.1\t4.1\tnormal rods=2 feed=90\n4.2\t6.2\toverfeed rods=2 "
             "feed=150\n");
  AnalyzerOptions options = options_for(at, "set");
  options.inputs = {at / "in/three.wav"};
  options.shards = 2;
  for (options.shard = 1; options.shard <= 2; ++options.shard) run_analyzer(options, {});
  CHECK(config::load_index(at / "set").laws.empty());
  options.shard = options.shards = 1;
  const AnalyzerResult whole = run_analyzer(options, {});
  CHECK(config::load_index(at / "set").laws.size() == 1);
  REQUIRE(whole.notes.size() == 1);
  CHECK(whole.notes[0].find("soundset.toml: laws of 2 rods: 3 banks at 40 to 150 bar") != std::string::npos);

  std::string text = read_text(at / "set/soundset.toml");
  const std::size_t at_level = text.find("ln_level = ", text.find("\n[[laws]]\n"));
  text.replace(at_level, text.find('\n', at_level) - at_level, "ln_level = 0.02");
  write_text(at / "set/soundset.toml", text);
  const AnalyzerResult again = run_analyzer(options, {});
  CHECK(read_text(at / "set/soundset.toml") == text);
  REQUIRE(again.notes.size() == 1);
  CHECK(again.notes[0].find("are kept, but the banks say other") != std::string::npos);
}
