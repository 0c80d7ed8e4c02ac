// `rigsound`: one command, many verbs. Exit codes: 0 done, 1 wrong input, 2 wrong usage, 3 machine failed.
#include <cstdio>
#include <exception>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"
#include "verbs.hpp"

using namespace rigsound;

namespace {

constexpr tools::AddVerb kVerbs[] = {
    tools::add_analyze, tools::add_background, tools::add_bench,    tools::add_check,  tools::add_clicks,
    tools::add_ctl,     tools::add_decode,     tools::add_denoise,  tools::add_record, tools::add_render,
    tools::add_replay,  tools::add_resynth,    tools::add_simulate, tools::add_tool,
};

/// A full disk behind a redirected stdout shows only now.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw DeviceError("standard output: cannot be written: disk full?");
}

int run(int argc, char** argv) {
  CLI::App app("The sound of a percussive drilling rig, from recordings and a fieldbus.", "rigsound");
  app.require_subcommand(1);
  app.set_version_flag("--version", RIGSOUND_VERSION);
  for (const tools::AddVerb add : kVerbs) add(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  flush_output();
  return 0;
}

int complain(const std::exception& error, int code) {
  std::fflush(stdout);
  std::fprintf(stderr, "%s\n", error.what());
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const DeviceError& error) {
    return complain(error, 3);
  } catch (const std::exception& error) {
    return complain(error, 1);
  }
}
