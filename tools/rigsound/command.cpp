#include "command.hpp"

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

namespace rigsound::tools {
namespace {

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

int run(const AddVerb* first, const AddVerb* last, int argc, char** argv) {
  cli::Program program("rigsound", "Give a simulator's cabin the sound of a percussive drilling rig",
                       RIGSOUND_VERSION);
  cli::Verb verb = program.verb();
  verb.example("rigsound render config/rigs/demo.toml --log config/logs/shift.log --out out/demo.wav");
  for (const AddVerb* add = first; add != last; ++add) (*add)(verb);
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

int run_command(const AddVerb* first, const AddVerb* last, int argc, char** argv) {
  keep_standard_streams();
  end_on_signals();
  try {
    return run(first, last, argc, argv);
  } catch (const DeviceError& error) {
    return complain(error, 3);
  } catch (const std::exception& error) {
    return complain(error, 1);
  }
}

}  // namespace rigsound::tools
