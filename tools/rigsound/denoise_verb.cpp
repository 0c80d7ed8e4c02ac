// rigsound denoise: a drill without the machine it sits on.
#include <memory>

#include "chain_arguments.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct DenoiseOptions {
  ChainArguments chain;
  std::string output, noise;
};

void run(const DenoiseOptions& options) {
  const analysis::Recording recording = read_input(options.chain);
  const analysis::ChainResult result = run_chain(recording, options.chain, Denoising::kOn);
  analysis::write_wave(options.output, analysis::at_source_rate(recording, result.drilling),
                       recording.source_rate);
  if (!options.noise.empty()) {
    std::vector<float> background(recording.mono);
    for (size_t n = 0; n < background.size(); ++n) background[n] -= result.drilling[n];
    analysis::write_wave(options.noise, analysis::at_source_rate(recording, background),
                         recording.source_rate);
  }
  if (!result.drilling_found) report_nothing_found(options.chain, result);
}

}  // namespace

void add_denoise(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("denoise", "remove the background from a recording of drilling");
  const auto options = std::make_shared<DenoiseOptions>();
  add_chain_arguments(*verb, options->chain);
  verb->add_option("output", options->output,
                   "the drilling alone: mono, 32-bit float WAV, same rate and length")
      ->required()
      ->type_name("OUT.wav");
  verb->add_option("--noise", options->noise, "what was removed; both add up to the recording")
      ->type_name("NOISE.wav");
  verb->footer(
      "Where no clicks are found the background is removed without them; the reason is told on stderr, exit "
      "code 0.\n\n"
      "Example: rigsound denoise rock.wav drilling.wav --noise diesel.wav");
  verb->callback([options] { run(*options); });
}

}  // namespace rigsound::tools
