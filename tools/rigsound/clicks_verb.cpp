// rigsound clicks: when the drill strikes, and how hard.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "chain_arguments.hpp"
#include "rigsound/analysis/rate.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct ClicksOptions {
  ChainArguments chain;
  bool no_denoise = false;
};

void run(const ClicksOptions& options) {
  const analysis::Recording recording = read_input(options.chain);
  const analysis::ChainResult result =
      run_chain(recording, options.chain, options.no_denoise ? Denoising::kOff : Denoising::kOn);
  std::string csv = "time_s,amplitude\n";
  for (size_t i = 0; i < result.clicks.P.size(); ++i)
    csv +=
        fmt::format("{:.6f},{:.6g}\n", result.clicks.P[i] / analysis::kAnalysisRate, result.clicks.beta[i]);
  std::fputs(csv.c_str(), stdout);
  if (!result.drilling_found) report_nothing_found(options.chain, result);
}

}  // namespace

void add_clicks(cli::Verb& program) {
  cli::Verb verb =
      program.verb("clicks", "Find the clicks of a percussive drill in a recording").group(kPrepare);
  const auto options = std::make_shared<ClicksOptions>();
  add_chain_arguments(verb, options->chain);
  verb.flag("--no-denoise", options->no_denoise, "take the recording as clean");
  verb.details(
      "Writes CSV to stdout: time_s (onset, seconds of the recording), amplitude (full scale 1), sorted by "
      "time. "
      "A recording without drilling gives the header alone, the reason on stderr, and exit code 0: it is no "
      "error.");
  verb.example("rigsound clicks rock.wav > clicks.csv");
  verb.callback([options] { run(*options); });
}

}  // namespace rigsound::tools
