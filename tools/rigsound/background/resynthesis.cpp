#include "background/resynthesis.hpp"

#include <vector>

#include "endings.hpp"
#include "progress_bar.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/time_table.hpp"
#include "rigsound/analysis/wave_file.hpp"

namespace rigsound::tools {

void write_resynthesis(const ResynthesisOptions& o, const DieselModel& model) {
  const double rpm = o.rpm > 0 ? o.rpm : model.points.front().rpm;
  const auto samples = static_cast<std::size_t>(o.seconds * analysis::kAnalysisRate);
  const std::vector<double> track =
      o.track.empty() ? std::vector<double>(samples, rpm)
                      : analysis::at_every_sample(analysis::read_time_table(o.track, "rpm"), samples);
  const double load = o.load >= 0 ? o.load : model.points.front().load;
  const std::vector<float> sound = [&] {
    ProgressBar bar;
    return analysis::play_diesel(model, track, load, o.feed, o.seed,
                                 [&bar](double share) { bar.show(share); });
  }();
  tell_clipped(o.file, analysis::write_wave(o.file, sound, static_cast<int>(analysis::kAnalysisRate)));
}

void add_resynthesis_options(cli::Verb& verb, ResynthesisOptions& o) {
  const cli::Option file =
      verb.option("--resynth", o.file,
                  "sound to write (.wav, .flac or .ogg): the model played by the engine's own voice");
  verb.option("--seconds", o.seconds, "length of it").shows_default().range(0.1, 36000, "s").needs(file);
  const cli::Option rpm = verb.option("--resynth-rpm", o.rpm, "its speed (default: the first recording's)")
                              .range(1, 4000, "r/min")
                              .needs(file);
  verb.option("--resynth-track", o.track, "CSV time_s,rpm: its course of speed").needs(file).excludes(rpm);
  verb.option("--resynth-load", o.load, "its load").range(0, 1).needs(file);
  verb.option("--resynth-feed", o.feed, "feed pressure, share of the overfeed pressure")
      .range(0, 1)
      .needs(file);
  verb.option("--seed", o.seed, "the same seed gives the same samples").shows_default();
}

}  // namespace rigsound::tools
