// rigsound denoise: a drill without the machine it sits on.
#include <memory>

#include "chain_arguments.hpp"
#include "endings.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/file/read_files.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct DenoiseOptions {
  ChainArguments chain;
  std::string output, noise;
};

/// Refuses outputs that would replace the recording or one another.
void check_names(const DenoiseOptions& options) {
  require_apart({options.output, options.noise}, {options.chain.input});
  require_sound_ending("OUT.wav", options.output);
  require_sound_ending("--noise", options.noise);
}

std::vector<float> background(const analysis::Recording& recording, const std::vector<float>& drilling) {
  std::vector<float> rest(recording.mono);
  for (size_t n = 0; n < rest.size(); ++n) rest[n] -= drilling[n];
  return rest;
}

void run(const DenoiseOptions& options) {
  check_names(options);
  const analysis::Recording recording = read_input(options.chain);
  const analysis::ChainResult result = run_chain(recording, options.chain, Denoising::kOn);
  const auto write = [&recording](const AtomicFile& file, const std::vector<float>& x) {
    tell_clipped(file.target().string(),
                 analysis::write_wave(file, analysis::at_source_rate(recording, x), recording.source_rate));
  };
  const std::vector<float> drilling = result.drilling.all();
  AtomicFile output(options.output);
  write(output, drilling);
  if (!options.noise.empty()) {
    AtomicFile noise(options.noise);
    write(noise, background(recording, drilling));
    noise.commit();
  }
  output.commit();
  report_where(options.chain, result);
}

}  // namespace

void add_denoise(cli::Verb& program) {
  cli::Verb verb =
      program.verb("denoise", "Remove the background from a recording of drilling").group(kPrepare);
  const auto options = std::make_shared<DenoiseOptions>();
  add_chain_arguments(verb, options->chain);
  verb.positional("OUT.wav", options->output,
                  "the drilling alone, mono, same rate and length: .wav of 32-bit float, .flac or .ogg")
      .required();
  verb.option("--noise", options->noise, "what was removed; both add up to the recording").type("NOISE.wav");
  verb.details(
      "Where no clicks are found the background is removed without them; the reason is told on stderr, exit "
      "code "
      "0. Of two machines --machine keeps one and removes the other with the background.");
  verb.example("rigsound denoise rock.wav drilling.wav --noise diesel.wav");
  verb.callback([options] { run(*options); });
}

}  // namespace rigsound::tools
