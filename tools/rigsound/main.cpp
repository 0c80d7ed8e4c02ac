// `rigsound`: one command, many verbs. Exit codes: 0 done, 1 wrong input, 2 wrong usage, 3 machine failed.
#include <cstdio>
#include <exception>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"
#include "verbs.hpp"

using namespace rigsound;

namespace {

/// As the help lists them.
constexpr tools::AddVerb kVerbs[] = {
    tools::add_denoise,  tools::add_clicks,  tools::add_analyze, tools::add_background, tools::add_tool,
    tools::add_simulate, tools::add_pack,    tools::add_unpack,  tools::add_render,     tools::add_record,
    tools::add_replay,   tools::add_ctl,     tools::add_check,   tools::add_decode,     tools::add_timeline,
    tools::add_contrast, tools::add_resynth, tools::add_bench,
};

/// A full disk behind a redirected stdout shows only now.
void flush_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw DeviceError("standard output: cannot be written: disk full?");
}

int run(int argc, char** argv) {
  cli::Program program("rigsound", "Give a simulator's cabin the sound of a percussive drilling rig",
                       RIGSOUND_VERSION);
  cli::Verb verb = program.verb();
  verb.example("rigsound render config/rigs/demo.toml --log config/logs/shift.log --out out/demo.wav");
  for (const tools::AddVerb add : kVerbs) add(verb);
  const int code = program.run(argc, argv);
  flush_output();
  return code;
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
