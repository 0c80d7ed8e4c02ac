#include "chain_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "kept_memory.hpp"
#include "progress_bar.hpp"
#include "read_recording.hpp"
#include "rigsound/file/atomic_folder.hpp"
#include "rigsound/file/read_files.hpp"

namespace rigsound::tools {

using namespace analysis;

void add_chain_arguments(cli::Verb& verb, ChainArguments& arguments) {
  arguments.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  verb.positional(
          "IN.wav", arguments.input,
          "recording: any format of libsndfile, 16 kHz or more; several channels are mixed down; `-`: "
          "standard input")
      .required();
  verb.option("--method", arguments.method, "click-nmf, or paper: the drilling paper's own chain")
      .one_of({"click-nmf", "paper"})
      .shows_default();
  verb.option("--machine", arguments.machine,
              "where two machines strike at rates of their own, only number N, 1 being the louder; 0: both")
      .range(0, 2)
      .shows_default();
  verb.option("--jobs", arguments.jobs, "threads; the result does not depend on their number")
      .at_least(1)
      .shows_default();
  verb.option("--dump", arguments.dump,
              "folder for the intermediate signals, clicks and powers of every step")
      .type("DIR");
}

Recording read_input(const ChainArguments& arguments) {
  if (!arguments.dump.empty()) require_outside(arguments.dump, {arguments.input});
  Recording recording = read_recording_or_silence(arguments.input);
  tell_how_read(arguments.input, recording);
  return recording;
}

ChainResult run_chain(const Recording& recording, const ChainArguments& arguments, Denoising denoising) {
  keep_freed_memory();
  if (recording.silent) {
    ChainResult nothing;
    nothing.reason = "it is silent";
    nothing.drilling = std::vector<float>(recording.mono.size());
    return nothing;
  }
  ProgressBar bar;
  std::optional<AtomicFolder> dump;
  if (!arguments.dump.empty()) dump.emplace(arguments.dump);
  ChainOptions options;
  options.method = arguments.method == "paper" ? Method::kPaper : Method::kClickNmf;
  options.denoise = denoising == Denoising::kOn;
  if (dump) options.dump = dump->temporary();
  options.machine = arguments.machine;
  options.jobs = arguments.jobs;
  options.progress = [&bar](int done, int total) { bar.show(done, total); };
  ChainResult result = analysis::run_chain(recording.mono, options);
  if (dump) dump->join();
  return result;
}

void report_where(const ChainArguments& arguments, const ChainResult& result) {
  const std::string machines = machines_text(result.machines);
  if (!machines.empty()) fmt::print(stderr, "{}: {}\n", arguments.input, machines);
  const std::string stretches = stretches_text(result.verdict);
  if (!result.drilling_found)
    fmt::print(stderr, "{}: no drilling found: {}\n", arguments.input, result.reason);
  else if (!stretches.empty())
    fmt::print(stderr, "{}: {}\n", arguments.input, stretches);
}

}  // namespace rigsound::tools
