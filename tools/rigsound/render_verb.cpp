#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "log_notes.hpp"
#include "rigsound/audio/wav_sink.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/log/log_states.hpp"
#include "sha256.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct Options {
  std::string rig, log, out;
  std::optional<std::uint64_t> seed;
};

audio::WavSink::Format format_of(const EngineOptions& options) {
  return {static_cast<int>(options.sample_rate), options.channels, options.block};
}

void render(const Options& options) {
  config::Rig rig = config::load_rig(options.rig);
  require_can(rig);
  if (options.seed) rig.engine.seed = *options.seed;
  log::CanLog log(options.log, rig.can);
  log::LogStates states(log, rig.safety, rig.engine);
  SoundSet sounds = config::load_sounds(rig);
  Engine engine(rig.engine, std::move(sounds));

  Sha256 digest;
  audio::WavSink sink(options.out, format_of(rig.engine),
                      [&](const void* bytes, std::size_t size) { digest.update(bytes, size); });
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t blocks = audio::run_blocks(engine, states, sink);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  sink.commit();
  const double length_s = static_cast<double>(blocks) * rig.engine.block / rig.engine.sample_rate;
  fmt::print("sha256 {}\nrealtime_factor {:.2f}\n", digest.hex(), length_s / spent.count());
  print_log_notes(options.log, log);
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("render", "Renders a recorded bus offline: the same input gives the same bits.");
  auto options = std::make_shared<Options>();
  verb->add_option("RIG.toml", options->rig, "the rig")->required();
  verb->add_option("--log", options->log, "CAN log as candump -l writes it")->required();
  verb->add_option("--out", options->out, "WAV file to write, 32 bit float")->required();
  verb->add_option("--seed", options->seed, "instead of the rig's seed");
  verb->callback([options] { render(*options); });
  verb->footer(
      "Prints `sha256 HEX` of the PCM bytes in the WAV's data chunk, then `realtime_factor X`: seconds of "
      "sound\n"
      "per second of rendering. Everything a frame says acts from the next block on; the sound ends with the "
      "log.\n\n"
      "Example: rigsound render config/rigs/demo.toml --log config/logs/shift.log --out out/demo.wav");
}

}  // namespace rigsound::tools
