// rigsound tool: the bar waveguide tuned to a steel, and fitted to its recorded sound; or a drill string.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "endings.hpp"
#include "figure_row.hpp"
#include "progress_bar.hpp"
#include "read_recording.hpp"
#include "rigsound/analysis/tool_fit.hpp"
#include "rigsound/analysis/tool_plot.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/read_files.hpp"
#include "standard_output.hpp"
#include "tool/drill_string.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct ToolOptions : ToolOutput {
  double length_m = 0, diameter_m = 0;
  std::string model = "designed", recording;
  std::vector<double> t60_T, t60_L;
  ToolModel tool;  ///< k_Tmin, k_Tmax, k_L, and the paper's M, lambda, N_T, N_L
  bool is_string = false;
  DrillStringOptions drill_string;
};

DecayWish wish_of(const std::vector<double>& t60) {
  return t60.empty() ? DecayWish{} : DecayWish{t60[0], t60[1], t60[2], t60[3]};
}

std::string name_of(const ToolOptions& o, const Bar& bar) {
  return !o.name.empty() ? o.name
                         : fmt::format("steel_{:.0f}x{:.0f}", 1000 * bar.length_m, 1000 * bar.diameter_m);
}

/// Which third octaves tell their decay, and how well.
void report_decays(const analysis::ToolFit& fit) {
  std::vector<double> excess;  // of the upper bound over the likeliest T60
  std::string at_least;
  for (const analysis::FittedBand& band : fit.bands) {
    const analysis::DecayBounds& decay = band.decay;
    if (decay.told()) excess.push_back(decay.high_s / decay.t60_s - 1);
    if (!decay.told() && decay.low_s > 0)
      at_least += fmt::format("{}at least {:.2g} s at {:.0f} Hz", at_least.empty() ? "" : ", ", decay.low_s,
                              band.centre_hz);
  }
  std::sort(excess.begin(), excess.end());
  fmt::print(stderr, "decays told in {} of {} third octaves: T60 within +{:.0f} % in half of them (95 %)\n",
             excess.size(), fit.bands.size(), 100 * excess[excess.size() / 2]);
  if (!at_least.empty()) fmt::print(stderr, "T60 {}: longer sound of one impact would tell more\n", at_least);
}

/// Modes that the steel's few losses cannot bring within the bounds.
void report_modes(const std::vector<TunedMode>& modes, const analysis::ToolFit& fit) {
  std::size_t shorter = 0, longer = 0, compared = 0;
  for (const TunedMode& mode : modes) {
    const analysis::FittedBand* const band = fit.band_at(mode.model_hz);
    if (band == nullptr || !band->decay.told()) continue;
    ++compared;
    shorter += mode.t60_s<band->decay.low_s, longer += mode.t60_s> band->decay.high_s;
  }
  if (shorter + longer > 0)
    fmt::print(stderr, "of {} modes, {} ring shorter than recorded and {} longer: loops decay by one law\n",
               compared, shorter, longer);
}

void report(const analysis::ToolFit& fit) {
  if (fit.estimated)
    fmt::print(stderr, "steel estimated from {} modes: {:.3f} m x {:.1f} mm\n", fit.matched_modes,
               fit.model.bar.length_m, 1000 * fit.model.bar.diameter_m);
  fmt::print(stderr,
             "impact at {:.3f} s, {:.0f} ms: third-octave error {:.2f} dB on average, {:.2f} dB at worst ({} "
             "bands)\n",
             fit.onset_s, 1000 * fit.length_s, fit.mean_error_db, fit.worst_error_db, fit.bands.size());
  report_decays(fit);
}

FigureRow band_row(const analysis::FittedBand& band) {
  FigureRow row;
  return row.add("centre_hz", band.centre_hz)
      .add("recorded_db", band.recorded_db)
      .add("recorded_low_db", band.recorded_low_db)
      .add("recorded_high_db", band.recorded_high_db)
      .add("model_db", band.model_db)
      .add("t60_s", band.decay.told() ? band.decay.t60_s : NAN)
      .add("t60_low_s", band.decay.low_s > 0 ? band.decay.low_s : NAN)
      .add("t60_high_s", band.decay.high_s)
      .add("heard_db", band.decay.heard_db);
}

Json fit_json(const analysis::ToolFit& fit) {
  FigureRow row;
  row.add("length_m", fit.model.bar.length_m)
      .add("diameter_m", fit.model.bar.diameter_m)
      .add_flag("estimated", fit.estimated)
      .add_count("matched_modes", static_cast<std::size_t>(fit.matched_modes))
      .add("onset_s", fit.onset_s)
      .add("mean_error_db", fit.mean_error_db)
      .add("worst_error_db", fit.worst_error_db);
  std::vector<FigureRow> bands;
  for (const analysis::FittedBand& band : fit.bands) bands.push_back(band_row(band));
  Json json = row.json();
  json["bands"] = json_list(bands);
  return json;
}

/// `fit`: nullptr without a recording.
FigureRow mode_row(const TunedMode& m, const analysis::ToolFit* fit) {
  FigureRow row;
  row.add("family", std::string(m.family))
      .add_count("mode", static_cast<std::size_t>(m.mode))
      .add("target_hz", m.target_hz, "{:.3f}")
      .add("model_hz", m.model_hz, "{:.3f}")
      .add("error_cents", m.error_cents, "{:.4f}")
      .add("t60_s", m.t60_s, "{:.6f}");
  if (fit == nullptr) return row;
  const analysis::FittedBand* const band = fit->band_at(m.model_hz);
  const bool heard = band != nullptr && band->decay.low_s > 0;
  return row.add("t60_low_s", heard ? band->decay.low_s : NAN, "{:.6f}")
      .add("t60_high_s", heard ? band->decay.high_s : NAN, "{:.6f}");
}

/// The steel as heard in the recording, if there is one.
std::optional<analysis::ToolFit> fit_of(const ToolOptions& o) {
  if (o.recording.empty()) return std::nullopt;
  const analysis::Recording recording = read_whole(o.recording, "struck steel");
  ProgressBar bar;
  analysis::ToolFit fit = analysis::fit_tool(recording, o.recording, {o.length_m, o.diameter_m},
                                             [&bar](double share) { bar.show(share); });
  bar.clear();
  report(fit);
  return fit;
}

/// The steel as asked for.
ToolModel model_of(const ToolOptions& o) {
  ToolModel model = o.tool;
  model.bar = {o.length_m, o.diameter_m};
  model.longitudinal.reflection_min = model.longitudinal.reflection_max;
  model.transversal.wish = wish_of(o.t60_T);
  model.longitudinal.wish = wish_of(o.t60_L);
  model.kind = o.model == "paper" ? ToolKind::kPaper : ToolKind::kDesigned;
  return model;
}

void print_figures(const ToolOptions& o, const std::vector<TunedMode>& modes, const analysis::ToolFit* fit) {
  std::vector<FigureRow> rows;
  for (const TunedMode& mode : modes) rows.push_back(mode_row(mode, fit));
  if (!o.json) {
    std::string csv = mode_row({}, fit).csv_head();
    for (const FigureRow& row : rows) csv += row.csv();
    std::fputs(csv.c_str(), stdout);
    return;
  }
  Json json;
  if (fit != nullptr) json["fit"] = fit_json(*fit);
  json["modes"] = json_list(rows);
  print_document(json);
}

void design_bar(const ToolOptions& o) {
  const std::optional<analysis::ToolFit> fit = fit_of(o);
  ToolModel model = fit ? fit->model : model_of(o);
  model.name = name_of(o, model.bar);
  const ToolDesign design = design_tool(model, o.rate);
  const std::vector<TunedMode> modes = tuned_modes(model, design);
  model.designs.clear();
  if (model.kind == ToolKind::kDesigned) model.designs = {design};
  if (!o.sound_set.empty()) {
    if (const auto kept = config::save_tool(o.sound_set, model); !kept.empty())
      fmt::print(stderr, "{} was there and differed: kept as {}\n", model.name, kept.string());
    config::SoundSetIndex index;
    index.tools = {{model.name}};
    config::merge_index(o.sound_set, index);
  }
  if (!o.plot.empty())
    write_file(o.plot,
               analysis::tool_plot_svg(fmt::format("{}: {:g} m x {:g} mm at {:g} Hz", model.name,
                                                   model.bar.length_m, 1000 * model.bar.diameter_m, o.rate),
                                       modes, fit ? fit->bands : std::vector<analysis::FittedBand>()));
  if (fit) report_modes(modes, *fit);
  print_figures(o, modes, fit ? &*fit : nullptr);
}

void run(const ToolOptions& o) {
  require_file("--plot", o.plot);
  require_apart({o.plot}, {o.recording});
  for (const std::string& sound_set : {o.sound_set, o.drill_string.rocks_of})
    require_apart({o.plot}, config::content_of(sound_set));
  require_ending("--plot", o.plot, {".svg"});
  if (!o.is_string) return design_bar(o);
  DrillStringOptions drill_string = o.drill_string;
  drill_string.model.rod_length_m = o.length_m;
  drill_string.model.rod_diameter_m = o.diameter_m;
  design_drill_string(drill_string, o);
}

/// The jackhammer paper's symbols, by its own names.
void add_paper_symbols(cli::Verb& verb, ToolModel& tool, const cli::Option& from, const cli::Option& string) {
  const auto add = [&](const char* name, auto& value, const char* text) {
    verb.option(name, value, text)
        .shows_default()
        .excludes(from)
        .excludes(string)
        .group("Symbols of the paper");
  };
  add("--k-Tmin", tool.transversal.reflection_min, "transversal reflection while the hammer touches");
  add("--k-Tmax", tool.transversal.reflection_max, "transversal reflection of the free tool");
  add("--k-L", tool.longitudinal.reflection_max, "longitudinal reflection");
  add("--M", tool.paper.M, "sections of its allpass cascade (--model paper), 1...64");
  add("--lambda", tool.paper.lambda, "their coefficient (--model paper)");
  add("--N-T", tool.paper.N_T, "transversal delay (--model paper), samples");
  add("--N-L", tool.paper.N_L, "longitudinal delay (--model paper), samples");
}

}  // namespace

void add_tool(cli::Verb& program) {
  cli::Verb verb =
      program.verb("tool", "Tune the ringing bar to a steel, or lay out a drill string").group(kPrepare);
  const auto o = std::make_shared<ToolOptions>();
  const cli::Option length =
      verb.option("--length", o->length_m, "of the steel, m (0.2...1.2), or of a rod (0.6...6.4)");
  const cli::Option diameter = verb.option("--diameter", o->diameter_m,
                                           "of the steel, m (0.010...0.080), or of a rod (0.025...0.076)");
  const cli::Option from =
      verb.option("--from", o->recording,
                  "recorded impact to fit decays, shelf, high-pass, equaliser, mix and pulse "
                  "width to; the steel is estimated from its modes where it is not given");
  const cli::Option string =
      verb.flag("--string", o->is_string, "a drill string of rods instead of a jackhammer's bar")
          .excludes(from);
  add_drill_string_options(verb, o->drill_string, string);
  verb.option("--rate", o->rate, "sample rate to design for, Hz").shows_default();
  verb.option("--model", o->model, "designed, or the jackhammer paper's own loops")
      .one_of({"designed", "paper"})
      .shows_default()
      .excludes(from)
      .excludes(string);
  for (const auto& [name, t60] :
       {std::pair{"--t60-transversal", &o->t60_T}, std::pair{"--t60-longitudinal", &o->t60_L}})
    verb.option(name, *t60, "wanted decay: LOW_HZ LOW_S HIGH_HZ HIGH_S")
        .count(4)
        .excludes(from)
        .excludes(string);
  add_paper_symbols(verb, o->tool, from, string);
  verb.option("--name", o->name,
              "of the tool in the sound set [steel_LENGTHxDIAMETER or string_RODSxLENGTHxDIAMETER, mm]");
  verb.option("--out", o->sound_set,
              "sound set to add the tool to; a tool of that name that differs is kept as NAME.json.old");
  verb.option("--plot", o->plot,
              "SVG to draw: wanted and reached modes, decays, and what a recording tells of them");
  verb.flag("--json", o->json, "figures as JSON instead of CSV");
  verb.details(
      "Writes CSV to stdout: family,mode,target_hz,model_hz,error_cents,t60_s. --from adds "
      "t60_low_s,t60_high_s: "
      "between which the recording has T60 around the mode, with 95 % confidence; up to `inf` where it is "
      "too "
      "short or too noisy to tell more than `at least`; empty where it tells nothing. The search keeps modes "
      "from "
      "ringing longer than the recording bears out; a recording that tells fewer than three decays is "
      "refused.\n--string "
      "has "
      "more columns and "
      "four "
      "families: `bending` of the rod outside the hole; `longitudinal` of the rods end to end, a comb; "
      "`longitudinal_jointed` with shank and sleeves, as the string plays; t60_pressed_s is T60 while full "
      "feed "
      "presses the bit on. `reflection` is what the bit sends back of a rectangular pulse of pulse_s, x "
      "loading "
      "times of the rock: share of the energy as the closed form has it and as the string plays it, largest "
      "force "
      "over the pulse's.");
  verb.example("rigsound tool --length 0.5 --diameter 0.025 --out soundset --plot modes.svg");
  verb.example("rigsound tool --from blow.wav --out soundset --json");
  verb.example(
      "rigsound tool --string --rods 6 --length 3.66 --diameter 0.038 --rock hard --plot string.svg");
  verb.callback([o, length, diameter] {
    if (o->recording.empty() && !(length.given() && diameter.given()))
      throw cli::UsageError("--length", "is needed with --diameter, or --from");
    run(*o);
  });
}

}  // namespace rigsound::tools
