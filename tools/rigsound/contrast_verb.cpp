// rigsound contrast: can the situations be told apart, and from which feed on?
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "contrast/contrast_output.hpp"
#include "endings.hpp"
#include "progress_bar.hpp"
#include "rigsound/analysis/contrast.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/read_files.hpp"
#include "rigsound/machine/fields.hpp"
#include "rigsound/machine/signal.hpp"
#include "standard_output.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

using namespace analysis;

struct ContrastArguments {
  std::string rig, report, boom;
  double engine_rpm = 1800;
  bool json = false;
  ContrastOptions contrast;
};

std::size_t boom_of(const config::Rig& rig, const std::string& wanted) {
  const std::vector<BoomOptions>& booms = rig.engine.booms;
  if (wanted.empty()) return 0;
  const auto found =
      std::find_if(booms.begin(), booms.end(), [&](const BoomOptions& b) { return b.name == wanted; });
  if (found != booms.end()) return static_cast<std::size_t>(found - booms.begin());
  std::string names;
  for (const BoomOptions& boom : booms) append_to_list(names, boom.name);
  throw cli::UsageError("--boom", "is " + wanted + ", expected " + names);
}

void contrast(const ContrastArguments& o) {
  const config::Rig rig = config::load_rig(o.rig);
  const std::size_t boom = boom_of(rig, o.boom);
  require_file("--report", o.report);
  require_apart({o.report}, config::files_of(rig));
  require_ending("--report", o.report, {".html", ".htm"});
  if (!o.report.empty()) AtomicFile(o.report);  // a page that cannot be written is told before the work
  const ContrastRig played = contrast_rig(rig, boom, o.engine_rpm);
  Contrast measured;
  {
    ProgressBar bar;
    measured = measure_contrast(played.plan, o.contrast, played.render,
                                [&bar](int done, int total) { bar.show(done, total); });
  }
  if (o.json)
    print_contrast_json(measured);
  else
    print_contrast_table(measured);
  std::fflush(stdout);
  for (const std::string& warning : contrast_warnings(measured)) fmt::print(stderr, "{}\n", warning);
  if (!o.report.empty()) write_contrast_page(o.report, measured);
}

}  // namespace

void add_contrast(cli::Verb& program) {
  cli::Verb verb =
      program.verb("contrast", "Tell whether the situations can be told apart, and from which feed on")
          .group(kInspect);
  auto o = std::make_shared<ContrastArguments>();
  ContrastOptions& c = o->contrast;
  c.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  verb.positional("RIG.toml", o->rig, "the rig, whose sound set and thresholds are meant").required();
  verb.option("--report", o->report, "also write one self-contained HTML page: verdicts, pairs, curves");
  verb.flag("--json", o->json, "figures as JSON instead of tables");
  verb.option("--seconds", c.seconds, "of each run").shows_default().range(4, 600, "s");
  verb.option("--runs", c.runs, "of each sound, with different seeds").shows_default().range(2, 32);
  verb.option("--seed", c.seed, "of the first run; the same seed gives the same figures").shows_default();
  verb.option("--boom", o->boom, "which drill, by its name [the first]");
  verb.option("--rpm", o->engine_rpm, "speed of the diesel meanwhile; 0: off")
      .shows_default()
      .range(0, info(Signal::kEngineRpm).max, "r/min");
  verb.option("--db-spl", c.full_scale_db_spl, "level at the ear of a sine of full scale")
      .shows_default()
      .range(40, 140, "dB SPL");
  verb.option("--jobs", c.jobs, "runs at the same time; figures do not depend on it")
      .range(1, 256)
      .shows_default();
  verb.callback([o] { contrast(*o); });
  verb.details(
      "Renders every situation and the feed pressure from contact to its end, measures how far the sounds "
      "are apart "
      "and how often a listener with an ear's noise tells one second of them right. A pair that cannot be "
      "told "
      "apart, overfeed above all, is named on stderr with `warning:`; the exit code stays 0.");
  verb.example("rigsound contrast config/rigs/demo.toml --report contrast.html");
  verb.example("rigsound contrast config/rigs/demo.toml --json");
}

}  // namespace rigsound::tools
