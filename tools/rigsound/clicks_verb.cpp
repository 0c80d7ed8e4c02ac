// rigsound clicks: when the drill strikes, and how hard.
#include <cstdio>
#include <memory>

#include "chain_arguments.hpp"
#include "figure_row.hpp"
#include "rigsound/analysis/rate.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct ClicksOptions {
  ChainArguments chain;
  bool no_denoise = false, json = false;
};

/// `machine` 0: there is only one.
FigureRow click_row(double onset_samples, double amplitude, int machine) {
  FigureRow row;
  row.add("time_s", onset_samples / analysis::kAnalysisRate, "{:.6f}").add("amplitude", amplitude, "{:.6g}");
  if (machine > 0) row.add_count("machine", static_cast<std::size_t>(machine));
  return row;
}

std::vector<FigureRow> click_rows(const analysis::ChainResult& result) {
  std::vector<FigureRow> rows;
  for (std::size_t i = 0; i < result.clicks.P.size(); ++i)
    rows.push_back(click_row(result.clicks.P[i], result.clicks.beta[i],
                             result.struck_by.empty() ? 0 : result.struck_by[i]));
  return rows;
}

std::vector<FigureRow> machine_rows(const analysis::ChainResult& result) {
  std::vector<FigureRow> rows;
  for (const analysis::Machine& m : result.machines)
    rows.push_back(FigureRow()
                       .add("rate_hz", m.rate_hz)
                       .add_count("clicks", m.clicks)
                       .add("level_db", m.level_db, "{:.2f}"));
  return rows;
}

std::vector<FigureRow> stretch_rows(const analysis::ChainResult& result) {
  std::vector<FigureRow> rows;
  if (!result.drilling_found) return rows;
  for (const analysis::Stretch& s : analysis::drilling_stretches(result.verdict))
    rows.push_back(FigureRow().add("start_s", s.start_s).add("end_s", s.end_s));
  return rows;
}

std::vector<FigureRow> window_rows(const analysis::ChainResult& result) {
  std::vector<FigureRow> rows;
  for (const analysis::VerdictWindow& w : result.verdict)
    rows.push_back(
        FigureRow().add("start_s", w.start_s).add("end_s", w.end_s).add("probability", w.probability));
  return rows;
}

void run(const ClicksOptions& options) {
  const analysis::Recording recording = read_input(options.chain);
  const analysis::ChainResult result =
      run_chain(recording, options.chain, options.no_denoise ? Denoising::kOff : Denoising::kOn);
  const std::vector<FigureRow> rows = click_rows(result);
  if (options.json) {
    print_document({{"recording", options.chain.input},
                    {"drilling_found", result.drilling_found},
                    {"reason", result.reason},
                    {"machines", json_list(machine_rows(result))},
                    {"drilling", json_list(stretch_rows(result))},
                    {"windows", json_list(window_rows(result))},
                    {"clicks", json_list(rows)}});
  } else {
    std::string csv = click_row(0, 0, result.struck_by.empty() ? 0 : 1).csv_head();
    for (const FigureRow& row : rows) csv += row.csv();
    std::fputs(csv.c_str(), stdout);
  }
  report_where(options.chain, result);
}

}  // namespace

void add_clicks(cli::Verb& program) {
  cli::Verb verb =
      program.verb("clicks", "Find the clicks of a percussive drill in a recording").group(kPrepare);
  const auto options = std::make_shared<ClicksOptions>();
  add_chain_arguments(verb, options->chain);
  verb.flag("--no-denoise", options->no_denoise, "take the recording as clean");
  verb.flag("--json", options->json, "clicks and verdict as one JSON document instead of CSV");
  verb.details(
      "Writes CSV to stdout: time_s (onset, seconds of the recording), amplitude (full scale 1), sorted by "
      "time; where two machines strike at rates of their own, machine (1: the louder), and stderr names both "
      "with their rates. "
      "Every window of 2 s gets a probability that it is drilling (--json prints them, one a second); clicks "
      "are those of stretches from 0.5 on, and beside such from 0.2 on, which are told on stderr when they "
      "are not all of it. "
      "A recording without drilling gives the header alone, the reason on stderr, and exit code 0: it is no "
      "error.");
  verb.example("rigsound clicks rock.wav > clicks.csv");
  verb.example("rigsound clicks rock.wav --json");
  verb.callback([options] { run(*options); });
}

}  // namespace rigsound::tools
