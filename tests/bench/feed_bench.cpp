// feed_bench [SEED...]: what is learned of a simulated feed ramp at +6 dB against its truth, and how far
// apart the situations are, in recordings and as their banks play.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <vector>

#include "bank/third_octave.hpp"
#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "rigsound/analysis/simulate.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "simulate/situation_recording.hpp"
#include "unit/analysis/analyzer/learned_drill.hpp"
#include "unit/temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

constexpr int kJobs = 2;

struct Worst {
  double rate = 0, level_db = 0, decay = 0;
  void take(const HeardErrors& e) {
    rate = std::max(rate, std::fabs(e.rate));
    level_db = std::max(level_db, std::fabs(e.level_db));
    decay = std::max(decay, std::fabs(e.decay));
  }
};

void print_errors(double feed, const char* where, const HeardErrors& e) {
  fmt::print("  {:7.1f} bar {:8}  rate {:+6.2f} %  level {:+6.2f} dB  decay {:+6.1f} %\n", feed, where,
             100 * e.rate, e.level_db, 100 * e.decay);
}

/// Wanted: rate within 1 %, level 0.5 dB, decay 10 %.
void ramp_rows(std::uint64_t seed) {
  const test::TemporaryFolder folder;
  const SoundSet sounds = learned_from_ramp(folder.path, {seed, 120, kJobs});
  const DrillingLaws truth(seed);
  fmt::print("ramp, seed {}: {} banks\n", seed, sounds.uses.size());
  Worst worst;
  const auto row = [&](double feed, const char* where) {
    const HeardErrors e = errors_at(sounds, truth, feed);
    worst.take(e);
    print_errors(feed, where, e);
  };
  for (const double feed : {20.0, 30.0}) row(feed, "below");
  for (std::size_t i = 0; i + 1 < sounds.uses.size(); ++i)
    row(0.5 * (sounds.uses[i].feed_bar + sounds.uses[i + 1].feed_bar), "between");
  for (const double feed : {170.0, 180.0, 190.0, 200.0}) row(feed, "above");
  for (const FeedLaws& l : sounds.laws)
    fmt::print("  laws: ln_gap {:.6f} ln_level {:.6f} ln_decay {:.6f}; true {:.6f} {:.6f} {:.6f}\n", l.ln_gap,
               l.ln_level, l.ln_decay, DrillingLaws::slopes().ln_gap, DrillingLaws::slopes().ln_level,
               DrillingLaws::slopes().ln_decay);
  fmt::print("  worst: rate {:.2f} % (wanted 1)  level {:.2f} dB (0.5)  decay {:.1f} % (10)\n",
             100 * worst.rate, worst.level_db, 100 * worst.decay);
}

struct Sound {
  Situation situation;
  double rate_hz;
  std::vector<float> recorded, played;
};

void print_pair(const Sound& a, const Sound& b, const char* of, std::vector<float> Sound::*sound) {
  const BandLevels x = third_octave_levels(a.*sound), y = third_octave_levels(b.*sound);
  fmt::print("  {:15} {:15} {:9} {:5.2f} dB, {:5.2f} dB without the level; rate {:4.1f} %\n",
             name(a.situation), name(b.situation), of, mean_difference_db(x, y, 200, Difference::kAbsolute),
             mean_difference_db(x, y, 200, Difference::kCentred),
             100 * std::fabs(std::log(a.rate_hz / b.rate_hz)));
}

/// Wanted: 3 dB, or 5 % of rate, between any two.
void situation_rows(std::uint64_t seed) {
  const test::TemporaryFolder folder;
  write_situations(folder.path, seed, 18);
  AnalyzerOptions options;
  options.inputs = {folder.path};
  options.sound_set = folder.path / "set";
  options.jobs = kJobs;
  options.tool_version = "bench";
  run_analyzer(options, {});
  const config::SoundSetIndex index = config::load_index(options.sound_set);
  std::vector<Sound> sounds;
  for (int i = 0; i < kSituationCount; ++i) {
    const auto situation = static_cast<Situation>(i);
    const SituationRecording r = simulate_situation(situation, seed, 18);
    Sound sound{situation, r.rate_hz, {r.clean.begin(), r.clean.end()}, {}};
    for (std::size_t n = 0; n < r.background.size(); ++n)
      sound.recorded[n] += static_cast<float>(r.background[n]);
    for (const config::BankEntry& entry : index.banks)
      if (entry.situation == situation)
        sound.played =
            resynthesise(config::load_bank(options.sound_set / "banks" / entry.name).bank, 20, 1).sound;
    sounds.push_back(std::move(sound));
  }
  fmt::print("situations, seed {}\n", seed);
  for (std::size_t b = 1; b < sounds.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      print_pair(sounds[a], sounds[b], "recorded", &Sound::recorded);
      print_pair(sounds[a], sounds[b], "played", &Sound::played);
    }
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::uint64_t> seeds;
  for (int i = 1; i < argc; ++i) seeds.push_back(std::strtoull(argv[i], nullptr, 10));
  if (seeds.empty()) seeds = {1, 2, 3};
  for (const std::uint64_t seed : seeds) {
    situation_rows(seed);
    ramp_rows(seed);
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
