// What `denoise` and `clicks` have in common: reading a recording and running the chain on it.
#pragma once

#include <string>

#include "cli/verb.hpp"
#include "rigsound/analysis/chain.hpp"
#include "rigsound/analysis/recording.hpp"

namespace rigsound::tools {

struct ChainArguments {
  std::string input;
  std::string method = "click-nmf";
  std::string dump;
  int machine = 0, jobs = 1;
};

/// IN.wav, --method, --machine, --jobs and --dump.
void add_chain_arguments(cli::Verb& verb, ChainArguments& arguments);

/// Reads the recording, which may be silent; tells on stderr how. Errors:
/// InputError.
analysis::Recording read_input(const ChainArguments& arguments);

/// Runs the chain with a progress bar; in silence it finds nothing. `denoise` false takes the recording as
/// clean.
enum class Denoising { kOn, kOff };
analysis::ChainResult run_chain(const analysis::Recording& recording, const ChainArguments& arguments,
                                Denoising denoising);

/// The line on stderr that says where the drilling is, unless everywhere, or why there is none.
void report_where(const ChainArguments& arguments, const analysis::ChainResult& result);

}  // namespace rigsound::tools
