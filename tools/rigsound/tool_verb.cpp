// rigsound tool: the bar waveguide tuned to a steel, and fitted to its recorded sound; or a drill string.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "endings.hpp"
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

void report(const analysis::ToolFit& fit) {
  if (fit.estimated)
    fmt::print(stderr, "steel estimated from {} modes: {:.3f} m x {:.1f} mm\n", fit.matched_modes,
               fit.model.bar.length_m, 1000 * fit.model.bar.diameter_m);
  fmt::print(stderr,
             "impact at {:.3f} s, {:.0f} ms: third-octave error {:.2f} dB on average, {:.2f} dB at worst ({} "
             "bands)\n",
             fit.onset_s, 1000 * fit.length_s, fit.mean_error_db, fit.worst_error_db, fit.bands.size());
}

nlohmann::ordered_json fit_json(const analysis::ToolFit& fit) {
  nlohmann::ordered_json json;
  json["length_m"] = fit.model.bar.length_m;
  json["diameter_m"] = fit.model.bar.diameter_m;
  json["estimated"] = fit.estimated;
  json["matched_modes"] = fit.matched_modes;
  json["onset_s"] = fit.onset_s;
  json["mean_error_db"] = fit.mean_error_db;
  json["worst_error_db"] = fit.worst_error_db;
  for (const analysis::FittedBand& band : fit.bands)
    json["bands"].push_back(
        {{"centre_hz", band.centre_hz}, {"recorded_db", band.recorded_db}, {"model_db", band.model_db}});
  return json;
}

void print_modes(const std::vector<TunedMode>& modes) {
  std::string csv = "family,mode,target_hz,model_hz,error_cents,t60_s\n";
  for (const TunedMode& m : modes)
    csv += fmt::format("{},{},{:.3f},{:.3f},{:.4f},{:.6f}\n", m.family, m.mode, m.target_hz, m.model_hz,
                       m.error_cents, m.t60_s);
  std::fputs(csv.c_str(), stdout);
}

void print_json(const std::vector<TunedMode>& modes, nlohmann::ordered_json json) {
  for (const TunedMode& m : modes)
    json["modes"].push_back({{"family", m.family},
                             {"mode", m.mode},
                             {"target_hz", m.target_hz},
                             {"model_hz", m.model_hz},
                             {"error_cents", m.error_cents},
                             {"t60_s", m.t60_s}});
  fmt::print("{}\n", json.dump(2));
}

/// The steel as asked for, or as heard in the recording.
ToolModel model_of(const ToolOptions& o, nlohmann::ordered_json& json) {
  if (!o.recording.empty()) {
    const analysis::ToolFit fit = [&] {
      const analysis::Recording recording = read_whole(o.recording, "struck steel");
      ProgressBar bar;
      return analysis::fit_tool(recording, o.recording, {o.length_m, o.diameter_m},
                                [&bar](double share) { bar.show(share); });
    }();
    report(fit);
    json["fit"] = fit_json(fit);
    return fit.model;
  }
  ToolModel model = o.tool;
  model.bar = {o.length_m, o.diameter_m};
  model.longitudinal.reflection_min = model.longitudinal.reflection_max;
  model.transversal.wish = wish_of(o.t60_T);
  model.longitudinal.wish = wish_of(o.t60_L);
  model.kind = o.model == "paper" ? ToolKind::kPaper : ToolKind::kDesigned;
  return model;
}

void design_bar(const ToolOptions& o) {
  nlohmann::ordered_json json;
  ToolModel model = model_of(o, json);
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
                                       modes));
  if (o.json) {
    print_json(modes, std::move(json));
  } else {
    print_modes(modes);
  }
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
  verb.option("--plot", o->plot, "SVG to draw: wanted and reached modes, decays");
  verb.flag("--json", o->json, "figures as JSON instead of CSV");
  verb.details(
      "Writes CSV to stdout: family,mode,target_hz,model_hz,error_cents,t60_s. --string has more columns and "
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
  verb.example(
      "rigsound tool --string --rods 6 --length 3.66 --diameter 0.038 --rock hard --plot string.svg");
  verb.callback([o, length, diameter] {
    if (o->recording.empty() && !(length.given() && diameter.given()))
      throw cli::UsageError("--length", "is needed with --diameter, or --from");
    run(*o);
  });
}

}  // namespace rigsound::tools
