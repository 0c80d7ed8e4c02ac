// One function a verb: adds the subcommand, whose callback does the work.
#pragma once

#include <CLI/CLI.hpp>

namespace rigsound::tools {

using AddVerb = void (*)(CLI::App& app);

void add_analyze(CLI::App& app);
void add_bench(CLI::App& app);
void add_check(CLI::App& app);
void add_clicks(CLI::App& app);
void add_ctl(CLI::App& app);
void add_decode(CLI::App& app);
void add_denoise(CLI::App& app);
void add_record(CLI::App& app);
void add_render(CLI::App& app);
void add_replay(CLI::App& app);
void add_resynth(CLI::App& app);
void add_simulate(CLI::App& app);

}  // namespace rigsound::tools
