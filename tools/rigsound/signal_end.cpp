#include "signal_end.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "rigsound/file/unfinished.hpp"

namespace rigsound::tools {
namespace {

int signal_pipe[2];  // a handler reaches nothing but what is global

/// Undoing takes locks and memory, which a handler must not: a thread does it.
void hand_on(int signal) {
  const auto number = static_cast<unsigned char>(signal);
  [[maybe_unused]] const ssize_t wrote = ::write(signal_pipe[1], &number, 1);
  // Who writes on into a pipe without a reader would complain of it until the end comes.
  if (signal == SIGPIPE)
    for (;;) ::pause();
}

[[noreturn]] void end_by(int signal) {
  undo_unfinished();
  if (signal != SIGPIPE) ::_exit(128 + signal);
  std::signal(SIGPIPE, SIG_DFL);
  sigset_t only;
  ::sigemptyset(&only);
  ::sigaddset(&only, SIGPIPE);
  ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  std::raise(SIGPIPE);
  ::_exit(128 + SIGPIPE);
}

void wait_for_the_end() {
  unsigned char number = 0;
  if (::read(signal_pipe[0], &number, 1) == 1) end_by(number);
}

}  // namespace

void end_on_signals() {
  if (::pipe2(signal_pipe, O_CLOEXEC) != 0) return;  // then the system's own way
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &before);  // for that thread, which inherits it
  std::thread(wait_for_the_end).detach();
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = hand_on;
    action.sa_flags = SA_RESTART;
    ::sigfillset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace rigsound::tools
