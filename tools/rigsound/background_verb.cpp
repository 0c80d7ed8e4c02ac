// rigsound background: the engine of a rig from recordings of it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "background_paper.hpp"
#include "number_range.hpp"
#include "rigsound/analysis/background_plot.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/analysis/time_table.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/config/background_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/machine/input_error.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

namespace fs = std::filesystem;

constexpr double kSlowest_rpm = 300, kFastest_rpm = 4000;  // of an engine that runs

struct BackgroundOptions {
  std::vector<std::string> inputs, rpm_tracks, clicks;
  std::vector<double> rpm, load;
  std::string out, name, plot, start, stop, resynth, resynth_track, model = "engine";
  double seconds = 10, resynth_rpm = 0, resynth_load = -1, resynth_feed = 0;
  unsigned seed = 1;
  bool formula = false, json = false;
  analysis::DieselSettings settings;
  PaperOptions paper;
};

/// The i-th of a list that has one entry for all, one for each, or none.
template <class T>
T nth(const std::vector<T>& list, std::size_t i, T absent) {
  return list.empty() ? absent : list[std::min(i, list.size() - 1)];
}

/// A track that ends long before its recording, or names speeds no engine has, is the wrong file.
std::vector<double> speed_log(const std::string& file, std::size_t samples) {
  constexpr double kMissing_s = 1;
  const analysis::TimeTable table = analysis::read_time_table(file, "rpm");
  const double seconds = static_cast<double>(samples) / analysis::kAnalysisRate;
  if (table.time_s.front() > kMissing_s || table.time_s.back() < seconds - kMissing_s)
    throw InputError(file, fmt::format("covers {:.1f}...{:.1f} s, expected all of the recording's {:.1f} s",
                                       table.time_s.front(), table.time_s.back(), seconds));
  for (std::size_t row = 0; row < table.value.size(); ++row)
    if (!(table.value[row] >= kSlowest_rpm && table.value[row] <= kFastest_rpm))
      throw InputError(file, 0, "rpm",
                       fmt::format("is {:g} at {:g} s, expected {:.0f}...{:.0f} r/min", table.value[row],
                                   table.time_s[row], kSlowest_rpm, kFastest_rpm));
  return analysis::at_every_sample(table, samples);
}

std::vector<analysis::DieselTake> takes_of(const BackgroundOptions& o) {
  std::vector<analysis::DieselTake> takes;
  for (std::size_t i = 0; i < o.inputs.size(); ++i) {
    const analysis::Recording recording = analysis::read_recording(o.inputs[i], {}, "engine");
    analysis::DieselTake take;
    take.source = o.inputs[i];
    take.mono = recording.mono;
    take.source_rate = recording.source_rate;
    take.clipped = recording.clipped;
    if (o.rpm_tracks.empty())
      take.rpm = nth(o.rpm, i, 0.0);
    else
      take.rpm_log = speed_log(nth(o.rpm_tracks, i, std::string()), take.mono.size());
    take.load = nth(o.load, i, 0.0);
    if (!o.clicks.empty())
      take.impacts_s = analysis::read_time_table(nth(o.clicks, i, std::string()), "amplitude").time_s;
    takes.push_back(std::move(take));
  }
  return takes;
}

void require_matching(const BackgroundOptions& o) {
  const auto matches = [&](std::size_t given, const char* option) {
    if (given > 1 && given != o.inputs.size())
      throw CLI::ValidationError(option, fmt::format("{} given for {} recordings, expected one or one each",
                                                     given, o.inputs.size()));
  };
  matches(o.rpm.size(), "--rpm");
  matches(o.load.size(), "--load");
  matches(o.clicks.size(), "--clicks");
  if (!o.rpm_tracks.empty() && o.rpm_tracks.size() != o.inputs.size())
    throw CLI::ValidationError("--rpm-track", "expected one track a recording");
  if (o.inputs.empty() != o.formula)
    throw CLI::ValidationError("IN", "expected either recordings or --formula");
  if (!o.formula && o.rpm.empty() && o.rpm_tracks.empty())
    throw CLI::ValidationError("--rpm", "is needed, or --rpm-track");
  if (o.out.empty() && o.resynth.empty()) throw CLI::ValidationError("--out", "is needed, or --resynth");
}

void write_resynthesis(const BackgroundOptions& o, const DieselModel& model) {
  const double rpm = o.resynth_rpm > 0 ? o.resynth_rpm : model.points.front().rpm;
  const auto samples = static_cast<std::size_t>(o.seconds * analysis::kAnalysisRate);
  const std::vector<double> track =
      o.resynth_track.empty()
          ? std::vector<double>(samples, rpm)
          : analysis::at_every_sample(analysis::read_time_table(o.resynth_track, "rpm"), samples);
  const double load = o.resynth_load >= 0 ? o.resynth_load : model.points.front().load;
  analysis::write_wave(o.resynth, analysis::play_diesel(model, track, load, o.resynth_feed, o.seed),
                       static_cast<int>(analysis::kAnalysisRate));
}

nlohmann::ordered_json report(const analysis::LearnedDiesel& learned, const BackgroundOptions& o) {
  const DieselModel& m = learned.model;
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  double samples = 0;
  for (const analysis::LearnedPoint& p : learned.points) {
    samples += p.seconds * analysis::kAnalysisRate;
    points.push_back({{"source", p.source},
                      {"rpm", p.rpm},
                      {"load", p.load},
                      {"cycles", p.cycles},
                      {"correlation", p.correlation},
                      {"synchronous", p.synchronous}});
  }
  const auto parameters = static_cast<double>(analysis::parameter_count(m));
  return {{"background", m.name},
          {"points", points},
          {"body_known", !m.body.db.empty()},
          {"oscillators", m.oscillators.size()},
          {"grains", m.points.front().grains.size()},
          {"bytes", 4 * parameters},
          {"samples_per_parameter", samples / parameters},
          {"sound_set", o.out}};
}

std::string line_of(const nlohmann::ordered_json& r) {
  double low = 1e9, high = 0, cycles = 0, correlation = 1;
  for (const auto& p : r["points"]) {
    low = std::min(low, p["rpm"].get<double>()), high = std::max(high, p["rpm"].get<double>());
    cycles += p["cycles"].get<double>();
    correlation = std::min(correlation, p["correlation"].get<double>());
  }
  const std::string speed =
      high - low < 1 ? fmt::format("{:.0f}", low) : fmt::format("{:.0f}..{:.0f}", low, high);
  return fmt::format(
      "{} points={} rpm={} cycles={:.0f} correlation={:.2f} body={} grains={} kB={:.1f} ratio={:.0f}",
      r["background"].get<std::string>(), r["points"].size(), speed, cycles, correlation,
      r["body_known"].get<bool>() ? "known" : "unknown", r["grains"].get<int>(),
      r["bytes"].get<double>() / 1000, r["samples_per_parameter"].get<double>());
}

void save(const BackgroundOptions& o, const DieselModel& model) {
  if (o.out.empty()) return;
  fs::create_directories(fs::path(o.out) / "backgrounds");
  config::save_background(o.out, model);
  config::SoundSetIndex index;
  index.backgrounds = {model.name};
  config::merge_index(o.out, index);
}

void learn(BackgroundOptions o) {
  require_matching(o);
  o.settings.name = !o.name.empty() ? o.name
                    : o.formula     ? "formula"
                                    : fs::path(o.inputs.front()).stem().string();
  analysis::LearnedDiesel learned;
  std::vector<analysis::DieselTake> takes;
  if (o.formula) {
    learned.model = default_diesel();
    learned.model.name = o.settings.name;
    for (const DieselPoint& p : learned.model.points)
      learned.points.push_back({p.source, p.rpm, p.load, 0, 0, 1, 1});
  } else {
    takes = takes_of(o);
    learned = analysis::learn_diesel(takes, o.settings);
  }
  for (const std::string& warning : learned.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  if (!o.start.empty()) learned.model.start = analysis::read_recording(o.start, {}, "engine").mono;
  if (!o.stop.empty()) learned.model.stop = analysis::read_recording(o.stop, {}, "engine").mono;
  save(o, learned.model);
  if (!o.resynth.empty()) write_resynthesis(o, learned.model);
  if (!o.plot.empty()) analysis::write_background_plot(o.plot, takes, learned.model);
  const nlohmann::ordered_json figures = report(learned, o);
  std::printf("%s\n", o.json ? figures.dump().c_str() : line_of(figures).c_str());
}

void add_learning_options(CLI::App& verb, BackgroundOptions& o) {
  verb.add_option("recordings", o.inputs,
                  "recordings of one engine, each at one speed or with its speed track");
  verb.add_option("--out", o.out, "sound set to write backgrounds/NAME into");
  auto* rpm = verb.add_option("--rpm", o.rpm, "r/min of each recording, within 3 %")
                  ->delimiter(',')
                  ->check(number_between(300.0, 4000.0));
  verb.add_option("--rpm-track", o.rpm_tracks, "CSV time_s,rpm of each recording")->excludes(rpm);
  verb.add_option("--load", o.load, "engine load of each recording, 0...1")
      ->delimiter(',')
      ->check(number_between(0.0, 1.0));
  verb.add_option("--name", o.name, "name of the background (default: that of the first recording)");
  verb.add_option("--clicks", o.clicks,
                  "CSV of `rigsound clicks`: the blows in each recording, not listened to");
  verb.add_option("--grains", o.settings.grains, "cycles to keep for the high layer, from clean recordings")
      ->expected(0, 1)
      ->default_str("48")
      ->check(CLI::Range(48, 1000));
  verb.add_option("--crossover", o.settings.crossover_hz, "Hz, between the low and the high layer")
      ->check(number_between(200.0, 800.0));
  verb.add_option("--start", o.start, "recording of the engine being started, kept as it is");
  verb.add_option("--stop", o.stop, "recording of the engine dying away, kept as it is");
  verb.add_flag("--formula", o.formula, "the built-in diesel instead of recordings");
  verb.add_option("--plot", o.plot, "SVG: spectrum with orders and cyclic envelope, recorded and modelled");
  verb.add_flag("--json", o.json, "the figures as JSON");
}

void add_resynthesis_options(CLI::App& verb, BackgroundOptions& o) {
  auto* resynth =
      verb.add_option("--resynth", o.resynth, "WAV to write: the model played by the engine's own voice");
  verb.add_option("--seconds", o.seconds, "length of it")
      ->capture_default_str()
      ->check(number_between(0.1, 36000.0))
      ->needs(resynth);
  auto* rpm =
      verb.add_option("--resynth-rpm", o.resynth_rpm, "its speed, r/min (default: the first recording's)")
          ->check(number_between(1.0, 4000.0))
          ->needs(resynth);
  verb.add_option("--resynth-track", o.resynth_track, "CSV time_s,rpm: its course of speed")
      ->needs(resynth)
      ->excludes(rpm);
  verb.add_option("--resynth-load", o.resynth_load, "its load")
      ->check(number_between(0.0, 1.0))
      ->needs(resynth);
  verb.add_option("--resynth-feed", o.resynth_feed, "feed pressure, share of the overfeed pressure")
      ->check(number_between(0.0, 1.0))
      ->needs(resynth);
  verb.add_option("--seed", o.seed, "the same seed gives the same samples")->capture_default_str();
}

}  // namespace

void add_background(CLI::App& app) {
  auto* verb = app.add_subcommand("background",
                                  "Learns the engine behind the drill: a background that follows the "
                                  "speed and never loops");
  auto o = std::make_shared<BackgroundOptions>();
  add_learning_options(*verb, *o);
  add_resynthesis_options(*verb, *o);
  verb->add_option("--model", o->model, "engine, or paper: harmonic-band wavelets of a sustained note")
      ->capture_default_str()
      ->check(CLI::IsMember({"engine", "paper"}));
  add_paper_options(*verb, o->paper);
  verb->footer(
      "Examples: rigsound background idle.wav --rpm 800 --out soundset --name diesel\n"
      "          rigsound background idle.wav mid.wav top.wav --rpm 800,1500,2300 --out soundset --name "
      "diesel\n"
      "          rigsound background runup.wav --rpm-track rpm.csv --out soundset --resynth out.wav\n"
      "          rigsound background note.wav --model paper --resynth out.wav");
  verb->callback([o] {
    if (o->model == "paper")
      model_note(o->inputs, o->resynth, o->seed, o->json, o->paper);
    else
      learn(*o);
  });
}

}  // namespace rigsound::tools
