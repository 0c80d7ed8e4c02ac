// rigsound background: the diesel of a rig from recordings of it.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "background/figures.hpp"
#include "background/learning.hpp"
#include "background/paper.hpp"
#include "background/resynthesis.hpp"
#include "endings.hpp"
#include "rigsound/analysis/background_plot.hpp"
#include "rigsound/config/background_files.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/file/make_folders.hpp"
#include "rigsound/file/read_files.hpp"
#include "standard_output.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct BackgroundOptions {
  std::string out, plot, model = "engine";
  bool json = false;
  LearningOptions learning;
  ResynthesisOptions resynthesis;
  PaperOptions paper;
};

void save(const std::string& sound_set, const DieselModel& model) {
  make_folders(std::filesystem::path(sound_set) / "backgrounds");
  config::save_background(sound_set, model);
  config::SoundSetIndex index;
  index.backgrounds = {model.name};
  config::merge_index(sound_set, index);
}

void learn_and_save(const BackgroundOptions& o) {
  if (o.out.empty() && o.resynthesis.file.empty()) throw cli::UsageError("--out", "is needed, or --resynth");
  const std::vector<analysis::DieselTake> takes = read_takes(o.learning);
  const analysis::LearnedDiesel learned = learn(takes, o.learning);
  for (const std::string& warning : learned.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
  if (!o.out.empty()) save(o.out, learned.model);
  if (!o.resynthesis.file.empty()) write_resynthesis(o.resynthesis, learned.model);
  if (!o.plot.empty()) analysis::write_background_plot(o.plot, takes, learned.model);
  std::fprintf(figures_beside({o.plot, o.resynthesis.file}), "%s\n",
               (o.json ? figures_json(learned, o.out) : figures_line(learned)).c_str());
}

/// What the verb reads: recordings, tracks of the speed, clicks to keep out.
std::vector<std::filesystem::path> inputs(const BackgroundOptions& o) {
  std::vector<std::filesystem::path> files = {o.learning.start, o.learning.stop, o.resynthesis.track};
  for (const auto* names : {&o.learning.inputs, &o.learning.rpm_tracks, &o.learning.clicks})
    files.insert(files.end(), names->begin(), names->end());
  return files;
}

void run(const BackgroundOptions& o) {
  std::vector<std::filesystem::path> read = inputs(o);
  if (!o.out.empty()) {
    const std::filesystem::path sound_set = o.out;
    require_outside(sound_set / "backgrounds" / background_name(o.learning), read);
    const std::vector<std::filesystem::path> set = config::content_of(sound_set);
    read.insert(read.end(), set.begin(), set.end());
  }
  require_apart({o.plot, o.resynthesis.file}, read);
  require_sound_ending("--resynth", o.resynthesis.file);
  require_ending("--plot", o.plot, {".svg"});
  if (o.model == "paper")
    model_note(o.learning.inputs, o.resynthesis.file, o.resynthesis.seed, o.json, o.paper);
  else
    learn_and_save(o);
}

}  // namespace

void add_background(cli::Verb& program) {
  cli::Verb verb =
      program.verb("background", "Learn the diesel behind the drill: it follows the speed and never loops")
          .group(kPrepare);
  auto o = std::make_shared<BackgroundOptions>();
  add_learning_options(verb, o->learning);
  verb.option("--out", o->out, "sound set to write backgrounds/NAME into");
  verb.option("--plot", o->plot, "SVG: spectrum with orders and cyclic envelope, recorded and modelled");
  verb.flag("--json", o->json, "the figures as JSON");
  add_resynthesis_options(verb, o->resynthesis);
  verb.option("--model", o->model, "engine, or paper: harmonic-band wavelets of a sustained note")
      .shows_default()
      .one_of({"engine", "paper"});
  add_paper_options(verb, o->paper);
  verb.example("rigsound background idle.wav --rpm 800 --out soundset --name diesel");
  verb.example("rigsound background idle.wav --out soundset --json");
  verb.example(
      "rigsound background idle.wav mid.wav top.wav --rpm 800,1500,2300 --out soundset --name diesel");
  verb.example("rigsound background runup.wav --rpm-track rpm.csv --out soundset --resynth out.wav");
  verb.example("rigsound background note.wav --model paper --resynth out.wav");
  verb.callback([o] { run(*o); });
}

}  // namespace rigsound::tools
