// rigsound resynth: one bank, offline, with the paper's six controls.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "number_range.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct ResynthOptions {
  std::string bank, output, impacts;
  double seconds = 0;
  std::uint64_t seed = 1;
  DrillControls controls;
};

void write_impacts(const std::string& path, const analysis::Resynthesis& result, double rate) {
  std::string text = "time_s,amplitude\n";
  for (const analysis::ResynthImpact& blow : result.impacts)
    text += fmt::format("{:.6f},{:.6f}\n", blow.time / rate, blow.amplitude);
  write_file(path, text);
}

void resynth(const ResynthOptions& o) {
  const ClickBank bank = config::load_bank(o.bank).bank;
  const analysis::Resynthesis result = analysis::resynthesise(bank, o.seconds, o.seed, o.controls);
  if (!o.impacts.empty()) write_impacts(o.impacts, result, bank.sample_rate);
  analysis::write_wave(o.output, result.sound, static_cast<int>(std::lround(bank.sample_rate)));
}

}  // namespace

void add_resynth(CLI::App& app) {
  auto* verb = app.add_subcommand("resynth", "Plays one bank offline, exactly as the engine plays it live");
  auto o = std::make_shared<ResynthOptions>();
  DrillControls& c = o->controls;
  verb->add_option("bank", o->bank, "folder of the bank, SOUNDSET/banks/NAME")->required();
  verb->add_option("output", o->output, "WAV to write")->required();
  verb->add_option("--seconds", o->seconds, "length")->required()->check(number_between(0.01, 36000.0));
  verb->add_option("--seed", o->seed, "the same seed gives the same samples")->capture_default_str();
  verb->add_option("--rate", c.mean_frequency_hz, "clicks a second instead of the bank's own")
      ->check(number_between(1.0, 100.0));
  verb->add_option("--gain-db", c.mean_amplitude_db, "louder or softer")->check(number_between(-60.0, 24.0));
  verb->add_option("--jitter", c.deviation_time, "factor on the deviation in time")
      ->check(number_between(0.0, 4.0));
  verb->add_option("--amp-jitter", c.deviation_amplitude, "factor on the deviation in amplitude")
      ->check(number_between(0.0, 4.0));
  verb->add_option("--attack", c.attack_factor, "factor on the attack time")
      ->check(number_between(0.1, 10.0));
  verb->add_option("--decay", c.decay_factor, "factor on the decay rate: 2 is twice as short")
      ->check(number_between(0.25, 10.0));
  verb->add_option("--impacts", o->impacts, "also write the blows as CSV time_s,amplitude");
  verb->footer("Example: rigsound resynth soundset/banks/normal out.wav --seconds 8 --rate 42 --decay 1.5");
  verb->callback([o] { resynth(*o); });
}

}  // namespace rigsound::tools
