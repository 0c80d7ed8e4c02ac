// `rigsound`: one command, many verbs. Exit codes: 0 done, 1 wrong input, 2 wrong usage, 3 machine failed.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"
#include "signal_end.hpp"
#include "verbs.hpp"

using namespace rigsound;

namespace {

/// As the help lists them.
constexpr tools::AddVerb kVerbs[] = {
    tools::add_denoise,  tools::add_clicks,   tools::add_analyze,  tools::add_background, tools::add_tool,
    tools::add_simulate, tools::add_merge,    tools::add_pack,     tools::add_unpack,     tools::add_studio,
    tools::add_render,   tools::add_record,   tools::add_replay,   tools::add_ctl,        tools::add_check,
    tools::add_decode,   tools::add_timeline, tools::add_contrast, tools::add_resynth,    tools::add_bench,
};

/// A file opened on the number of a closed stream would get what is printed.
void keep_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);  // writing to it fails, as it did
}

[[noreturn]] void fail_output(int error) {
  throw DeviceError(std::string("standard output: cannot be written: ") + std::strerror(error));
}

/// A full disk behind a redirected stdout shows only now.
void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) fail_output(errno != 0 ? errno : EIO);
}

int run(int argc, char** argv) {
  cli::Program program("rigsound", "Give a simulator's cabin the sound of a percussive drilling rig",
                       RIGSOUND_VERSION);
  cli::Verb verb = program.verb();
  verb.example("rigsound render config/rigs/demo.toml --log config/logs/shift.log --out out/demo.wav");
  for (const tools::AddVerb add : kVerbs) add(verb);
  try {
    const int code = program.run(argc, argv);
    flush_output();
    return code;
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) == 0) throw;
    fail_output(error.code().value());
  }
}

int complain(const std::exception& error, int code) {
  std::fflush(stdout);
  std::fprintf(stderr, "%s\n", error.what());
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  tools::end_on_signals();
  try {
    return run(argc, argv);
  } catch (const DeviceError& error) {
    return complain(error, 3);
  } catch (const std::exception& error) {
    return complain(error, 1);
  }
}
