#include "tool/drill_string.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "figure_row.hpp"
#include "rigsound/analysis/string_figures.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

using analysis::ReflectionRow, analysis::StringFigures;

struct Family {
  const char* name;  ///< in the output
  std::vector<StringMode> StringFigures::*modes;
};
constexpr Family kFamilies[] = {{"bending", &StringFigures::bending},
                                {"longitudinal", &StringFigures::rods},
                                {"longitudinal_jointed", &StringFigures::string}};

bool is_sound_set(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "soundset.toml");
}

/// The sound set whose rocks are meant: --set, or the one that is written to if it is there already.
std::filesystem::path rocks_of(const DrillStringOptions& o, const ToolOutput& output) {
  if (!o.rocks_of.empty()) return o.rocks_of;
  return is_sound_set(output.sound_set) ? output.sound_set : "";
}

/// CSV has one table of both kinds of rows: a mode has nothing in the columns of a reflection, and the other
/// way round.
constexpr double kNone = NAN;

FigureRow mode_row(const char* family, const StringMode& m) {
  FigureRow row;
  return row.add("family", family)
      .add_count("mode", static_cast<std::size_t>(m.mode))
      .add("target_hz", m.target_hz, "{:.3f}")
      .add("model_hz", m.model_hz, "{:.3f}")
      .add("error_cents", m.error_cents, "{:.4f}")
      .add("t60_s", m.t60_s, "{:.6f}")
      .add("t60_pressed_s", m.t60_pressed_s, "{:.6f}");
}

FigureRow reflection_row(const ReflectionRow& r) {
  FigureRow row;
  return row.add("pulse_s", r.pulse_s, "{:.9f}")
      .add("x", r.x, "{:.6f}")
      .add("target_share", r.target, "{:.6f}")
      .add("model_share", r.reached.energy, "{:.6f}")
      .add("force", r.reached.force, "{:.6f}");
}

void print_csv(const StringFigures& figures) {
  const FigureRow no_reflection = reflection_row({kNone, kNone, kNone, {kNone, kNone}});
  std::string csv = (mode_row("", {}) + no_reflection).csv_head();
  for (const Family& family : kFamilies)
    for (const StringMode& m : figures.*family.modes) csv += (mode_row(family.name, m) + no_reflection).csv();
  int row = 0;
  for (const ReflectionRow& r : figures.reflection) {
    StringMode none;
    none.mode = ++row;
    none.target_hz = none.model_hz = none.error_cents = none.t60_s = none.t60_pressed_s = kNone;
    csv += (mode_row("reflection", none) + reflection_row(r)).csv();
  }
  std::fputs(csv.c_str(), stdout);
}

void print_json(const StringFigures& figures, const config::RockEntry& rock) {
  FigureRow stone, blow;
  stone.add("name", rock.name).add("stiffness_n_per_m", rock.stiffness).add("loading_s", figures.loading_s);
  blow.add("x", figures.blow_x).add("model_share", figures.blow.energy).add("force", figures.blow.force);
  std::vector<FigureRow> modes, reflection;
  for (const Family& family : kFamilies)
    for (const StringMode& m : figures.*family.modes) modes.push_back(mode_row(family.name, m));
  for (const ReflectionRow& r : figures.reflection) reflection.push_back(reflection_row(r));
  print_document({{"rock", stone.json()},
                  {"blow", blow.json()},
                  {"modes", json_list(modes)},
                  {"reflection", json_list(reflection)}});
}

/// "soft 5e+07, medium 2e+08, ... N/m"
std::string usual_rocks() {
  std::string list;
  for (const config::RockEntry& rock : config::kUsualRocks)
    list += fmt::format("{}{} {:g}", list.empty() ? "" : ", ", rock.name, rock.stiffness);
  return list + " N/m";
}

/// A string stands on rock: a sound set that names none gets the usual ones.
void save(const StringModel& model, const std::string& sound_set) {
  if (const auto kept = config::save_string(sound_set, model); !kept.empty())
    fmt::print(stderr, "{} was there and differed: kept as {}\n", model.name, kept.string());
  config::SoundSetIndex index;
  index.tools = {{model.name, config::SteelKind::kString}};
  if (!is_sound_set(sound_set) || config::load_index(sound_set).rocks.empty())
    index.rocks = config::kUsualRocks;
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
