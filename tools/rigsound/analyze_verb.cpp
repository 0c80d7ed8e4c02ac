// rigsound analyze: recordings in, a sound set out.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <thread>

#include "endings.hpp"
#include "figure_row.hpp"
#include "kept_memory.hpp"
#include "progress_bar.hpp"
#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/report.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "shard.hpp"
#include "standard_output.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

using namespace analysis;

struct AnalyzeArguments {
  std::vector<std::string> inputs;
  std::string situation, method = "click-nmf", shard = "1/1", report, sound_set, labels, rig, bus_log;
  bool no_denoise = false, json = false;
  AnalyzerOptions options;
};

AnalyzerOptions options_of(const AnalyzeArguments& a) {
  AnalyzerOptions options = a.options;
  options.inputs.assign(a.inputs.begin(), a.inputs.end());
  options.sound_set = a.sound_set;
  options.labels = a.labels;
  options.rig = a.rig;
  options.bus_log = a.bus_log;
  if (!a.situation.empty()) options.situation = situation_by_name(a.situation);
  options.method = a.method == "paper" ? Method::kPaper : Method::kClickNmf;
  options.denoise = !a.no_denoise;
  options.report = a.report.empty() ? ReportSections::kSkip : ReportSections::kWrite;
  options.page = a.report;
  options.tool_version = RIGSOUND_VERSION;
  const Shard shard = read_shard(a.shard);
  options.shard = shard.number, options.shards = shard.count;
  return options;
}

FigureRow bank_row(const AnalysedPart& p) {
  const analysis::Label& label = p.part.label;
  FigureRow row;
  return row.add("bank", p.part.bank)
      .add("situation", std::string(name(label.situation)))
      .add_count("rods", static_cast<std::size_t>(label.rods))
      .add("feed_bar", label.feed_bar, "{}")
      .add("rate_hz", p.figures.rate_hz, "{:.3f}")
      .add_count("clicks", static_cast<std::size_t>(p.clicks))
      .add_count("found", static_cast<std::size_t>(p.figures.clicks_found))
      .add("level_db", p.figures.level_db, "{:.2f}")
      .add("snr_db", p.figures.snr_db, "{:.2f}")
      .add("ltas_error_db", p.figures.ltas_error_db, "{:.2f}")
      .add("ltas_denoised_error_db", p.figures.ltas_denoised_error_db, "{:.2f}")
      .add("modulation_error_db", p.figures.modulation_error_db, "{:.2f}")
      .add("source", p.part.recording.string());
}

/// The line begins with the bank's name alone.
void print_bank(const AnalysedPart& p) {
  fmt::print("{}\n", bank_row(p).words().substr(std::string("bank=").size()));
}

void print_json(const AnalyzerResult& result) {
  Json json{{"banks", Json::array()}, {"notes", result.notes}, {"failures", result.failures}};
  for (const AnalysedPart& p : result.banks) {
    Json bank = bank_row(p).json();
    bank["rock"] = p.part.label.rock;
    bank["machine"] = p.figures.machine;
    bank["machine_rates_hz"] = p.figures.machine_rates_hz;
    bank["warnings"] = p.warnings;
    json["banks"].push_back(std::move(bank));
  }
  print_document(json);
}

void analyze(const AnalyzeArguments& a) {
  const AnalyzerOptions options = options_of(a);
  require_file("--report", a.report);
  require_ending("--report", a.report, {".html", ".htm"});
  keep_freed_memory();
  if (!a.report.empty()) AtomicFile(a.report);  // a page that cannot be written is told before the work
  AnalyzerResult result;
  {
    ProgressBar bar;
    AnalyzerListener listener;
    listener.done = [&](const AnalysedPart& part) {
      if (a.json) return;
      bar.clear();  // both may be on one terminal
      print_bank(part);
      std::fflush(stdout);
    };
    listener.progress = [&bar](int analysed, int total) { bar.show(analysed, total); };
    result = run_analyzer(options, listener);
  }
  if (a.json) print_json(result);
  for (const std::string& note : result.notes) fmt::print(stderr, "{}\n", note);
  for (const AnalysedPart& p : result.banks)
    for (const std::string& warning : p.warnings)
      fmt::print(stderr, "{}: warning: {}\n", p.part.bank, warning);
  if (!a.report.empty()) write_report(a.report, options.sound_set, result);
  if (result.failures.empty()) return;
  for (std::size_t i = 0; i + 1 < result.failures.size(); ++i) fmt::print(stderr, "{}\n", result.failures[i]);
  throw std::runtime_error(result.failures.back());  // the last line, and exit code 1
}

}  // namespace

void add_analyze(cli::Verb& program) {
  cli::Verb verb = program.verb("analyze", "Learn a bank of clicks from every labelled part of recordings")
                       .group(kPrepare);
  auto a = std::make_shared<AnalyzeArguments>();
  AnalyzerOptions& o = a->options;
  o.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  verb.positional("IN", a->inputs, "recordings, and folders of recordings (not the folders inside)")
      .required();
  verb.option("--out", a->sound_set, "sound set; made if need be, never overwritten where people edit it")
      .required();
  const cli::Option labels = verb.option(
      "--labels", a->labels,
      "Audacity label file of the one recording; otherwise STEM.txt beside each recording is used");
  const cli::Option rig =
      verb.option("--rig", a->rig,
                  "rig file that describes the bus; a bus log STEM.log beside a recording is then read "
                  "instead of its labels")
          .type("RIG.toml");
  const cli::Option bus_log =
      verb.option("--bus-log", a->bus_log, "bus log of the one recording, instead of the one beside it")
          .needs(rig);
  verb.option("--bus-log-offset", o.bus_log_offset_s,
              "when in the recording the bus log begins, s; negative: before it")
      .needs(rig)
      .shows_default();
  verb.option("--situation", a->situation,
              "says of recordings without labels that they drill, from end to end; otherwise they are normal "
              "drilling where some is found")
      .one_of({kSituationNames.begin(), kSituationNames.end()});
  verb.option("--machine", o.machine,
              "where two machines strike at rates of their own, the one that is learned, 1 being the louder")
      .range(1, 2)
      .shows_default();
  verb.option("--jobs", o.jobs, "parts analysed at the same time; banks do not depend on it")
      .range(1, 256)
      .shows_default();
  verb.option("--shard", a->shard,
              "I/N: this run does every N-th part, I from 1 to N; auto: I and N of the Slurm array it is a "
              "task of, whatever number that begins with")
      .shows_default();
  verb.option("--report", a->report, "also write one self-contained HTML page that shows every bank");
  verb.flag("--json", a->json, "figures of all banks, notes and failures as one JSON document, at the end");
  verb.option("--method", a->method, "click-nmf, or paper: the drilling paper's own chain")
      .one_of({"click-nmf", "paper"})
      .shows_default();
  verb.option("--clicks", o.clicks, "most clicks in a bank").range(2, 1000).shows_default();
  verb.flag("--no-denoise", a->no_denoise, "take the recordings as clean");
  verb.details(
      "One line a bank on stdout, when it is done. Finished banks made from the same sound with the same "
      "settings are kept, "
      "so a "
      "run that was stopped goes on where it was. What gave no bank is listed at the end, and the exit code "
      "is "
      "then 1.\n"
      "A bus log cuts its recording by situation, rods, rock and feed pressure; a feed that moves gives a "
      "part "
      "every 10 bar. From banks of three feeds or more of one rod count and rock, how the sound goes on "
      "beyond "
      "them is written to soundset.toml as [[laws]].\n"
      "ltas_error_db: how far the spectrum of a bank is from what it aims at, the recorded drilling with "
      "what "
      "denoising took given back; ltas_denoised_error_db: how far from the denoised recording as it is.");
  verb.example("rigsound analyze recordings/ --out soundset --jobs 4 --report report.html");
  verb.example("rigsound analyze recordings/ --out soundset --json");
  verb.example(
      "rigsound analyze feed/ramp.wav --bus-log feed/ramp.log --rig config/rigs/demo.toml --out soundset");
  verb.example("sbatch --array=0-7 --wrap 'rigsound analyze recordings/ --out soundset --shard auto'");
  verb.callback([a] { analyze(*a); });
}

}  // namespace rigsound::tools
