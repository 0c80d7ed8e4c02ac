// `rigsoundd RIG.toml`: the daemon, in the foreground. Exit codes as for `rigsound`.
#include <sys/signalfd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>

#include <spdlog/spdlog.h>

#include "daemon.hpp"
#include "locked_memory.hpp"
#include "log_setup.hpp"
#include "rigsound/device_error.hpp"

using namespace rigsound;

namespace {

constexpr const char* kHelp =
    "SIGHUP, or `rigsound ctl reload`, reads the rig again: all of it is taken, or none. SIGTERM and SIGINT "
    "fade\n"
    "the sound out and end with 0. A missing sound card or bus is waited for.\n\n"
    "Example: rigsoundd config/rigs/demo.toml --session run.rigsession";

/// Blocked in this thread and in all it starts, so that only the descriptor sees them.
FileDescriptor take_signals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::sigaddset(&signals, signal);
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);  // a file at its limit is a full disk, not an end
  return FileDescriptor(::signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC));
}

int complain(const std::exception& error, int code) {
  daemon::stop_log();
  std::fprintf(stderr, "%s\n", error.what());
  return code;
}

int serve(const daemon::DaemonOptions& options) {
  const FileDescriptor signals = take_signals();
  try {
    daemon::start_log();
    const std::string memory = daemon::lock_memory();
    {
      daemon::Daemon daemon(options);
      spdlog::info("memory {}", memory);
      daemon.run(signals.get());
    }
    daemon::stop_log();
    return 0;
  } catch (const DeviceError& error) {
    return complain(error, 3);
  } catch (const std::exception& error) {
    return complain(error, 1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Plays a drilling rig's sound from its fieldbus, live.", "rigsoundd");
  daemon::DaemonOptions options;
  double limit_mb = 256;
  app.set_version_flag("--version", RIGSOUND_VERSION);
  app.add_option("RIG.toml", options.rig, "the rig")->required();
  app.add_option("--session", options.session.file,
                 "write what happens to FILE (older ones become FILE.1, FILE.2, FILE.3)");
  app.add_option("--session-limit", limit_mb, "MB that all session files together may take")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.footer(kHelp);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  options.session.limit_bytes = static_cast<std::uint64_t>(limit_mb * 1e6);
  return serve(options);
}
