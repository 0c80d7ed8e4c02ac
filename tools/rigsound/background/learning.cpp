#include "background/learning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "progress_bar.hpp"
#include "read_recording.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/time_table.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::tools {
using analysis::kFastestDiesel_rpm, analysis::kSlowestDiesel_rpm;

namespace {

/// The i-th of a list that has one entry for all, one for each, or none.
template <class T>
T nth(const std::vector<T>& list, std::size_t i, T absent) {
  return list.empty() ? absent : list[std::min(i, list.size() - 1)];
}

/// A track that ends long before its recording, or names speeds no diesel has, is the wrong file.
void check_speeds(const analysis::TimeTable& table, const std::string& file, double recording_s) {
  constexpr double kMissing_s = 1;
  if (table.time_s.front() > kMissing_s || table.time_s.back() < recording_s - kMissing_s)
    throw InputError(file, fmt::format("covers {:.1f}...{:.1f} s, expected all of the recording's {:.1f} s",
                                       table.time_s.front(), table.time_s.back(), recording_s));
  for (std::size_t row = 0; row < table.value.size(); ++row)
    if (!(table.value[row] >= kSlowestDiesel_rpm && table.value[row] <= kFastestDiesel_rpm))
      throw InputError(file, 0, "rpm",
                       fmt::format("is {:g} at {:g} s, expected {:.0f}...{:.0f} r/min", table.value[row],
                                   table.time_s[row], kSlowestDiesel_rpm, kFastestDiesel_rpm));
}

/// One recording, or the stretch of a long one that is enough.
analysis::DieselTake read_take(const LearningOptions& o, std::size_t i) {
  analysis::DieselTake take;
  take.source = o.inputs[i];
  const std::string track = nth(o.rpm_tracks, i, std::string());
  const analysis::TimeTable speeds =
      track.empty() ? analysis::TimeTable{} : analysis::read_time_table(track, "rpm");
  analysis::Stretch heard;
  analysis::Recording recording = read_stretch(
      take.source,
      [&](double recording_s) {
        if (!track.empty()) check_speeds(speeds, track, recording_s);
        return heard = analysis::learned_stretch(recording_s, speeds);
      },
      "engine");
  take.mono = std::move(recording.mono);
  take.source_rate = recording.source_rate;
  take.clipped = recording.clipped;
  if (track.empty())
    take.rpm = nth(o.rpm, i, 0.0);
  else
    take.rpm_log = analysis::at_every_sample(speeds, take.mono.size(), heard.start_s);
  take.load = nth(o.load, i, 0.0);
  if (o.clicks.empty()) return take;
  for (const double t : analysis::read_time_table(nth(o.clicks, i, std::string()), "amplitude").time_s)
    take.impacts_s.push_back(t - heard.start_s);
  return take;
}

void require_matching(const LearningOptions& o) {
  const auto matches = [&](std::size_t given, const char* option) {
    if (given > 1 && given != o.inputs.size())
      throw cli::UsageError(option, fmt::format("{} given for {} recordings, expected one or one each", given,
                                                o.inputs.size()));
  };
  matches(o.rpm.size(), "--rpm");
  matches(o.load.size(), "--load");
  matches(o.clicks.size(), "--clicks");
  if (!o.rpm_tracks.empty() && o.rpm_tracks.size() != o.inputs.size())
    throw cli::UsageError("--rpm-track", "expected one track a recording");
  if (o.inputs.empty() != o.formula) throw cli::UsageError("IN", "expected either recordings or --formula");
}

analysis::LearnedDiesel built_in() {
  analysis::LearnedDiesel learned;
  learned.model = default_diesel();
  for (const DieselPoint& p : learned.model.points)
    learned.points.push_back({p.source, p.rpm, p.load, 0, 0, 1, 1});
  return learned;
}

}  // namespace

std::string background_name(const LearningOptions& o) {
  if (!o.name.empty()) return o.name;
  return o.formula || o.inputs.empty() ? "formula" : std::filesystem::path(o.inputs.front()).stem().string();
}

std::vector<analysis::DieselTake> read_takes(const LearningOptions& o) {
  require_matching(o);
  std::vector<analysis::DieselTake> takes;
  for (std::size_t i = 0; i < o.inputs.size(); ++i) takes.push_back(read_take(o, i));
  return takes;
}

analysis::LearnedDiesel learn(const std::vector<analysis::DieselTake>& takes, const LearningOptions& o) {
  analysis::DieselSettings settings = o.settings;
  settings.name = background_name(o);
  ProgressBar bar;
  analysis::LearnedDiesel learned =
      o.formula ? built_in()
                : analysis::learn_diesel(takes, settings, [&bar](double share) { bar.show(share); });
  bar.clear();
  learned.model.name = settings.name;
  if (!o.start.empty()) learned.model.start = read_whole(o.start, "engine").mono;
  if (!o.stop.empty()) learned.model.stop = read_whole(o.stop, "engine").mono;
  return learned;
}

void add_learning_options(cli::Verb& verb, LearningOptions& o) {
  verb.positional("IN.wav", o.inputs, "recordings of one diesel, each at one speed or with its speed track");
  const cli::Option rpm = verb.option("--rpm", o.rpm, "speed of each recording, within 3 %; left out: heard")
                              .separated_by_commas()
                              .range(kSlowestDiesel_rpm, kFastestDiesel_rpm, "r/min");
  verb.option("--rpm-track", o.rpm_tracks, "CSV time_s,rpm of each recording").excludes(rpm);
  verb.option("--load", o.load, "engine load of each recording").separated_by_commas().range(0, 1);
  verb.option("--name", o.name, "name of the background (default: that of the first recording)");
  verb.option("--clicks", o.clicks,
              "CSV of `rigsound clicks`: the impacts in each recording, not listened to");
  verb.option("--grains", o.settings.grains, "cycles to keep for the high layer, from clean recordings")
      .value_or("48")
      .range(48, 1000, "cycles");
  verb.option("--crossover", o.settings.crossover_hz, "between the low and the high layer")
      .range(200, 800, "Hz");
  verb.option("--start", o.start, "recording of the diesel being started, kept as it is");
  verb.option("--stop", o.stop, "recording of the diesel dying away, kept as it is");
  verb.flag("--formula", o.formula, "the built-in diesel instead of recordings");
}

}  // namespace rigsound::tools
