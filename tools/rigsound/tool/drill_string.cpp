#include "tool/drill_string.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "rigsound/analysis/string_figures.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

using analysis::ReflectionRow, analysis::StringFigures;
using Json = nlohmann::ordered_json;

struct Family {
  const char* name;  ///< in the output
  std::vector<StringMode> StringFigures::*modes;
};
constexpr Family kFamilies[] = {{"bending", &StringFigures::bending},
                                {"longitudinal", &StringFigures::rods},
                                {"longitudinal_jointed", &StringFigures::string}};

/// The sound set whose rocks are meant: --set, or the one that is written to if it is there already.
std::filesystem::path rocks_of(const DrillStringOptions& o, const ToolOutput& output) {
  if (!o.rocks_of.empty()) return o.rocks_of;
  return std::filesystem::exists(std::filesystem::path(output.sound_set) / "soundset.toml") ? output.sound_set
                                                                                            : "";
}

void print_csv(const StringFigures& figures) {
  std::string csv =
      "family,mode,target_hz,model_hz,error_cents,t60_s,t60_pressed_s,pulse_s,x,target_share,model_share,"
      "force\n";
  for (const Family& family : kFamilies)
    for (const StringMode& m : figures.*family.modes)
      csv += fmt::format("{},{},{:.3f},{:.3f},{:.4f},{:.6f},{:.6f},,,,,\n", family.name, m.mode, m.target_hz,
                         m.model_hz, m.error_cents, m.t60_s, m.t60_pressed_s);
  int row = 0;
  for (const ReflectionRow& r : figures.reflection)
    csv += fmt::format("reflection,{},,,,,,{:.9f},{:.6f},{:.6f},{:.6f},{:.6f}\n", ++row, r.pulse_s, r.x,
                       r.target, r.reached.energy, r.reached.force);
  std::fputs(csv.c_str(), stdout);
}

Json modes_json(const char* family, const std::vector<StringMode>& modes) {
  Json list = Json::array();
  for (const StringMode& m : modes)
    list.push_back({{"family", family},
                    {"mode", m.mode},
                    {"target_hz", m.target_hz},
                    {"model_hz", m.model_hz},
                    {"error_cents", m.error_cents},
                    {"t60_s", m.t60_s},
                    {"t60_pressed_s", m.t60_pressed_s}});
  return list;
}

void print_json(const StringFigures& figures, const config::RockEntry& rock) {
  Json json;
  json["rock"] = {
      {"name", rock.name}, {"stiffness_n_per_m", rock.stiffness}, {"loading_s", figures.loading_s}};
  json["blow"] = {{"x", figures.blow_x}, {"model_share", figures.blow.energy}, {"force", figures.blow.force}};
  json["modes"] = Json::array();
  for (const Family& family : kFamilies)
    for (Json& mode : modes_json(family.name, figures.*family.modes))
      json["modes"].push_back(std::move(mode));
  for (const ReflectionRow& r : figures.reflection)
    json["reflection"].push_back({{"pulse_s", r.pulse_s},
                                  {"x", r.x},
                                  {"target_share", r.target},
                                  {"model_share", r.reached.energy},
                                  {"force", r.reached.force}});
  fmt::print("{}\n", json.dump(2));
}

/// "soft 5e+07, medium 2e+08, ... N/m"
std::string usual_rocks() {
  std::string list;
  for (const config::RockEntry& rock : config::kUsualRocks)
    list += fmt::format("{}{} {:g}", list.empty() ? "" : ", ", rock.name, rock.stiffness);
  return list + " N/m";
}

void save(const StringModel& model, const std::string& sound_set) {
  if (const auto kept = config::save_string(sound_set, model); !kept.empty())
    fmt::print(stderr, "{} was there and differed: kept as {}\n", model.name, kept.string());
  config::SoundSetIndex index;
  index.tools = {{model.name, config::SteelKind::kString}};
  config::merge_index(sound_set, index);
}

}  // namespace

void design_drill_string(DrillStringOptions o, const ToolOutput& output) {
  StringModel& model = o.model;
  model.name = !output.name.empty() ? output.name
                                    : fmt::format("string_{}x{:.0f}x{:.0f}", model.rods,
                                                  1000 * model.rod_length_m, 1000 * model.rod_diameter_m);
  const double exposed_m = o.exposed_m > 0 ? o.exposed_m : model.rod_length_m;
  const config::RockEntry rock = config::find_rock(rocks_of(o, output), o.rock);
  const StringFigures figures = analysis::string_figures(model, exposed_m, rock.stiffness, output.rate);
  if (!output.sound_set.empty()) save(model, output.sound_set);
  if (!output.plot.empty())
    write_file(output.plot,
               analysis::string_plot_svg(
                   fmt::format("{}: {} × {:g} m × {:g} mm, {:g} m exposed", model.name, model.rods,
                               model.rod_length_m, 1000 * model.rod_diameter_m, exposed_m),
                   fmt::format("rock \"{}\", {:.3g} MN/m", rock.name, 1e-6 * rock.stiffness), figures));
  if (output.json)
    print_json(figures, rock);
  else
    print_csv(figures);
}

void add_drill_string_options(cli::Verb& verb, DrillStringOptions& o, const cli::Option& string) {
  StringModel& m = o.model;
  const auto add = [&](const char* name, auto& value, const std::string& help) {
    return verb.option(name, value, help).needs(string).group("Drill string");
  };
  add("--rods", m.rods, "on the string").range(1, kMaxRods).shows_default();
  add("--exposed", o.exposed_m, "length of the upper rod outside the hole [all of it]").at_least(0.01, "m");
  add("--rock", o.rock,
      "what the bit stands on: a [[rock]] of the sound set, or an order of magnitude: " + usual_rocks())
      .shows_default();
  add("--set", o.rocks_of, "sound set whose rocks are meant [that of --out]");
  add("--shank", m.shank_length_m, "length of the shank adapter, m; 0: none").shows_default();
  add("--sleeve-impedance", m.sleeve_impedance, "of the coupling sleeves over that of the rods; 1: none")
      .shows_default();
  add("--sleeve-length", m.sleeve_length_m, "of the coupling sleeves, m").shows_default();
}

}  // namespace rigsound::tools
