// `rigsoundd RIG.toml`: the daemon, in the foreground. Exit codes as for `rigsound`.
#include <sys/signalfd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "cli/verb.hpp"
#include "daemon.hpp"
#include "locked_memory.hpp"
#include "log.hpp"
#include "rigsound/device_error.hpp"

using namespace rigsound;

namespace {

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
    const std::string memory = daemon::lock_memory();
    daemon::start_log();
    {
      daemon::Daemon daemon(options);
      daemon::log_info("memory " + memory);
      if (!daemon.run(signals.get())) {
        daemon::stop_log();
        std::_Exit(0);  // what the other thread uses must not be destroyed under it
      }
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
  cli::Program program("rigsoundd", "Play a drilling rig's sound from its fieldbus, live", RIGSOUND_VERSION);
  daemon::DaemonOptions options;
  std::string session;
  double limit_mb = 256;
  bool manual = false;
  int code = 0;
  cli::Verb verb = program.verb();
  verb.positional("RIG.toml", options.rig, "the rig").required();
  verb.option("--session", session,
              "write what happens to DIR, each run to a file named by the time it began")
      .type("DIR");
  verb.option("--session-limit", limit_mb, "that all sessions of DIR together may take; the oldest go first")
      .range(0.01, 1e6, "MB")
      .shows_default();
  verb.flag("--manual", manual, "open no bus: signals are what `rigsound ctl set` says");
  verb.details(
      "SIGHUP, or `rigsound ctl reload`, reads the rig again: all of it is taken, or none. SIGTERM and "
      "SIGINT fade "
      "the sound out and end with 0. A missing sound card or bus is waited for.\n"
      "With --manual neither the rig's buses nor the files they name are looked at. It is silent until you "
      "say:\n"
      "rigsound ctl set engine_rpm 1500 (the diesel runs)\n"
      "rigsound ctl set feed_pressure_bar 90 (it drills)\n"
      "rigsound ctl set feed_pressure_bar 160 (too much feed)");
  verb.example("rigsoundd config/rigs/demo.toml --session sessions");
  verb.example("rigsoundd config/rigs/demo.toml --manual");
  verb.callback([&] {
    if (manual) options.buses = config::Buses::kLeftOut;
    options.session.folder = session;
    options.session.limit_bytes = static_cast<std::uint64_t>(limit_mb * 1e6);
    code = serve(options);
  });
  const int usage = program.run(argc, argv);
  return usage != 0 ? usage : code;
}
