#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "endings.hpp"
#include "figure_row.hpp"
#include "log_arguments.hpp"
#include "log_notes.hpp"
#include "progress_bar.hpp"
#include "refused_values.hpp"
#include "rigsound/audio/excerpt.hpp"
#include "rigsound/audio/file_sink.hpp"
#include "rigsound/config/fingerprint.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/config/sha256.hpp"
#include "rigsound/default_diesel.hpp"
#include "rigsound/engine_sound.hpp"
#include "rigsound/file/read_files.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/session/log_states.hpp"
#include "rigsound/session/session_folder.hpp"
#include "rigsound/session/session_states.hpp"
#include "rigsound/session/table_states.hpp"
#include "standard_output.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct RenderArguments {
  std::string rig, session, states, out;
  LogArguments log;
  std::optional<std::uint64_t> seed;
  double from_s = 0, to_s = HUGE_VAL;
  bool no_hash = false, json = false;
};

/// How much of a source lies before a block, 0...1.
using Share = std::function<double(std::uint64_t)>;

Share share_of_blocks(double blocks) {
  return [blocks](std::uint64_t number) { return static_cast<double>(number) / std::max(1.0, blocks); };
}

/// Shows on its way how far a source has come.
class ShownStates : public audio::StateSource {
 public:
  ShownStates(audio::StateSource& states, Share share) : states_(states), share_(std::move(share)) {}
  const MachineState* state_of(std::uint64_t number) override {
    bar_.show(std::min(1.0, share_(number)));
    return states_.state_of(number);
  }
  std::uint64_t skipped_before(std::uint64_t number) override { return states_.skipped_before(number); }

 private:
  audio::StateSource& states_;
  Share share_;
  ProgressBar bar_;
};

/// Renders the source, from its beginning on, and prints the figures; --from and --to choose what OUT holds.
void render(config::Rig& rig, audio::StateSource& states, const Share& share, audio::SampleFormat samples,
            const RenderArguments& options) {
  SoundSet sounds = config::load_sounds(rig);
  const bool built_in_diesel = sounds.diesels.front().name == kDefaultDiesel;
  Engine engine = config::build_engine(rig, std::move(sounds));
  require_apart({options.out}, config::files_of(rig));
  const audio::BlockRange part = audio::blocks_of(options.from_s, options.to_s, rig.engine);
  std::optional<config::Sha256> digest;
  audio::FileSink::Tap hash;
  if (!options.no_hash)
    hash = [&digest = digest.emplace()](const void* bytes, std::size_t size) { digest.update(bytes, size); };
  const audio::FileSink::Format format{
      {static_cast<int>(rig.engine.sample_rate), rig.engine.channels, samples}, rig.engine.block};
  audio::FileSink file(options.out, format, hash);
  audio::LateSink sink(file, part.first);
  audio::EndingStates source(states, part.last);
  const Share share_of_part = share_of_blocks(static_cast<double>(part.last));
  std::optional<ShownStates> shown(std::in_place, source, [&](std::uint64_t number) {
    return std::max(share(number), share_of_part(number));
  });
  const auto start = std::chrono::steady_clock::now();
  std::vector<float> block = audio::make_block(engine.options());
  const std::uint64_t blocks = audio::run_blocks(engine, *shown, sink, block);
  shown.reset();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  const double length_s = static_cast<double>(blocks) * rig.engine.block / rig.engine.sample_rate;
  if (blocks <= part.first)
    throw cli::UsageError("--from",
                          fmt::format("{:g} s is after the end at {:.3f} s", options.from_s, length_s));
  file.commit();
  tell_clipped(options.out, file.clipped());
  std::FILE* const to = figures_beside({options.out});
  FigureRow figures;
  if (digest) figures.add("sha256", digest->hex());
  figures.add("realtime_factor", length_s / spent.count(), "{:.2f}");
  if (options.json)
    print_document(figures.json(), to);
  else
    fmt::print(to, "{}", figures.lines());
  if (built_in_diesel)
    fmt::print(stderr, "{}: no background model in the sound set; using the built-in diesel\n",
               rig.sound_set.string());
}

config::Rig rig_of(const RenderArguments& options, config::Buses buses) {
  config::Rig rig = config::load_rig(options.rig, buses);
  if (options.seed) rig.engine.seed = *options.seed;
  return rig;
}

void render_states(const RenderArguments& options) {
  config::Rig rig = rig_of(options, config::Buses::kLeftOut);
  session::TableStates states(options.states, rig.engine);
  render(rig, states, share_of_blocks(states.end_s() * rig.engine.sample_rate / rig.engine.block),
         audio::SampleFormat::kFloat, options);
}

void render_log(const RenderArguments& options) {
  config::Rig rig = rig_of(options, config::Buses::kRead);
  const std::unique_ptr<log::BusLog> log =
      log::open_log(options.log.log, config::buses_of(rig), log_options(options.log));
  session::LogStates states(*log, rig.safety, rig.engine);
  render(
      rig, states, [&](std::uint64_t) { return log->share(); }, audio::SampleFormat::kFloat, options);
  print_log_notes(options.log.log, *log);
  print_refused_values(rig, states.board());
}

/// The states are kept whatever happens to the engine; that it sounds as it did is not.
void print_other_engine(const std::string& file, const session::SessionHeader& header) {
  if (header.engine == kEngineSound) return;
  fmt::print(stderr, "{}: {}, this one is {}: to hear what was heard, render it with rigsound {}\n", file,
             header.engine.empty() ? "does not say which engine played it"
                                   : "was played by an engine of another sound, " + header.engine,
             kEngineSound, header.program);
}

/// What the session was rendered with counts; the rest must be what it was. Buses are not asked any more.
void render_session(RenderArguments options) {
  options.session = session::newest_session(options.session).string();
  config::Rig rig = config::load_rig(options.rig, config::Buses::kLeftOut);
  session::SessionStates states(options.session);
  const session::SessionHeader& header = states.header();
  rig.engine.seed = header.seed;
  rig.engine.sample_rate = header.sample_rate;
  rig.engine.block = header.block;
  rig.engine.channels = header.channels;
  const std::string fingerprint = config::fingerprint(rig);
  if (fingerprint != header.fingerprint)
    throw InputError(options.session, "was played with another rig or sound set (" + header.fingerprint +
                                          "), expected that of " + options.rig + " (" + fingerprint + ")");
  print_other_engine(options.session, header);
  render(rig, states, share_of_blocks(static_cast<double>(states.blocks())), header.format, options);
  if (states.bytes_ignored() > 0)
    fmt::print(stderr, "{}: the last {} bytes are not whole and were left out\n", options.session,
               states.bytes_ignored());
}

}  // namespace

void add_render(cli::Verb& program) {
  cli::Verb verb =
      program.verb("render", "Render a recorded bus offline: the same input gives the same bits").group(kRun);
  auto options = std::make_shared<RenderArguments>();
  verb.positional("RIG.toml", options->rig, "the rig").required();
  cli::Verb source = verb.exactly_one("Source");
  source.option("--log", options->log.log, kLogHelp);
  source.option("--session", options->session,
                "what rigsoundd --session wrote: the very samples it played; of a folder the newest");
  source.option("--states", options->states, "CSV as decode prints it: the state itself, no safety rule");
  verb.option("--out", options->out,
              "sound file to write: .wav of 32 bit float, or in the format of the session's card; .flac of "
              "24 bit; .ogg")
      .required();
  add_log_options(verb, options->log);
  verb.option("--seed", options->seed, "instead of the rig's seed; a session has its own");
  verb.option("--from", options->from_s, "OUT begins with the block that holds it").at_least(0, "s");
  verb.option("--to", options->to_s, "OUT ends with the block before it; left out: the end").at_least(0, "s");
  verb.flag("--no-hash", options->no_hash, "print no sha256");
  verb.flag("--json", options->json, "the figures as one JSON document");
  verb.callback([options] {
    require_apart({options->out}, {options->rig, options->log.log, options->session, options->states});
    require_sound_ending("--out", options->out);
    if (options->to_s <= options->from_s) throw cli::UsageError("--to", "expected more than --from");
    if (!options->log.log.empty())
      render_log(*options);
    else
      options->session.empty() ? render_states(*options) : render_session(*options);
  });
  verb.details(
      "Prints `sha256 HEX` of the PCM bytes as a WAV has them in its data chunk, then `realtime_factor X`: "
      "seconds of "
      "sound per "
      "second of rendering. Everything a frame or a row says acts from the next block on, and is heard "
      "[mix] lookahead_ms later, as live; the sound ends with the last "
      "one. With --from and --to OUT holds the very samples of that part of the whole. With `--out -` the "
      "sound goes to "
      "standard output and the figures to stderr.");
  verb.example("rigsound render config/rigs/demo.toml --log config/logs/shift.log --out out/demo.wav");
  verb.example("rigsound render rig.toml --states bus.csv --out bus.wav --json");
}

}  // namespace rigsound::tools
