// One function a verb: adds it to the program; its callback does the work.
#pragma once

#include "cli/verb.hpp"

namespace rigsound::tools {

/// Headings of the program's help, in the order of a user's work.
constexpr const char *kPrepare = "Prepare", *kRun = "Run", *kInspect = "Inspect";

using AddVerb = void (*)(cli::Verb& program);

void add_analyze(cli::Verb& program);
void add_background(cli::Verb& program);
void add_bench(cli::Verb& program);
void add_check(cli::Verb& program);
void add_clicks(cli::Verb& program);
void add_contrast(cli::Verb& program);
void add_ctl(cli::Verb& program);
void add_decode(cli::Verb& program);
void add_denoise(cli::Verb& program);
void add_record(cli::Verb& program);
void add_render(cli::Verb& program);
void add_replay(cli::Verb& program);
void add_resynth(cli::Verb& program);
void add_merge(cli::Verb& program);
void add_pack(cli::Verb& program);
void add_simulate(cli::Verb& program);
void add_studio(cli::Verb& program);
void add_timeline(cli::Verb& program);
void add_tool(cli::Verb& program);
void add_unpack(cli::Verb& program);

}  // namespace rigsound::tools
