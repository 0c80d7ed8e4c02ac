// rigsound resynth: one bank, offline, with the paper's six controls.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "endings.hpp"
#include "progress_bar.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/read_files.hpp"
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
  for (const analysis::ResynthImpact& impact : result.impacts)
    text += fmt::format("{:.6f},{:.6f}\n", impact.time / rate, impact.amplitude);
  write_file(path, text);
}

void resynth(const ResynthOptions& o) {
  require_apart({o.output, o.impacts}, {o.bank});
  require_sound_ending("OUT.wav", o.output);
  const ClickBank bank = config::load_bank(o.bank).bank;
  const analysis::Resynthesis result = [&] {
    ProgressBar bar;
    return analysis::resynthesise(bank, o.seconds, o.seed, o.controls,
                                  [&bar](double share) { bar.show(share); });
  }();
  if (!o.impacts.empty()) write_impacts(o.impacts, result, bank.sample_rate);
  const int rate = static_cast<int>(std::lround(bank.sample_rate));
  tell_clipped(o.output, analysis::write_wave(o.output, result.sound, rate));
}

}  // namespace

void add_resynth(cli::Verb& program) {
  cli::Verb verb =
      program.verb("resynth", "Play one bank offline, exactly as the engine plays it live").group(kInspect);
  auto o = std::make_shared<ResynthOptions>();
  DrillControls& c = o->controls;
  verb.positional("BANK", o->bank, "folder of the bank, SOUNDSET/banks/NAME").required();
  verb.positional("OUT.wav", o->output, "sound to write: .wav of 32-bit float, .flac or .ogg").required();
  verb.option("--seconds", o->seconds, "length").required().range(0.01, 36000, "s");
  verb.option("--seed", o->seed, "the same seed gives the same samples").shows_default();
  verb.option("--rate", c.mean_frequency_hz, "clicks a second instead of the bank's own").range(1, 100, "Hz");
  verb.option("--gain-db", c.mean_amplitude_db, "louder or softer").range(-60, 24, "dB");
  verb.option("--jitter", c.deviation_time, "factor on the deviation in time").range(0, 4);
  verb.option("--amp-jitter", c.deviation_amplitude, "factor on the deviation in amplitude").range(0, 4);
  verb.option("--attack", c.attack_factor, "factor on the attack time").range(0.1, 10);
  verb.option("--decay", c.decay_factor, "factor on the decay rate: 2 is twice as short").range(0.25, 10);
  verb.option("--impacts", o->impacts, "also write the impacts as CSV time_s,amplitude");
  verb.example("rigsound resynth soundset/banks/normal out.wav --seconds 8 --rate 42 --decay 1.5");
  verb.callback([o] { resynth(*o); });
}

}  // namespace rigsound::tools
