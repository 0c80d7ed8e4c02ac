#include "child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "rigsound/device_error.hpp"
#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::studio {
namespace {

constexpr std::size_t kMostErrorLines = 200;

struct Pipe {
  FileDescriptor in, out;

  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw DeviceError(std::string("no pipe: ") + std::strerror(errno));
    in.reset(ends[0]);
    out.reset(ends[1]);
  }
};

/// Bytes as they come, told line by line.
class Lines {
 public:
  explicit Lines(std::function<void(const std::string&)> tell) : tell_(std::move(tell)) {}

  /// False at the end.
  bool read(int fd) {
    std::array<char, 4096> bytes{};
    const ssize_t got = ::read(fd, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) return true;
    if (got <= 0) {
      if (!unfinished_.empty()) tell_(unfinished_);
      return false;
    }
    for (ssize_t i = 0; i < got; ++i) {
      if (bytes[static_cast<std::size_t>(i)] != '\n') {
        unfinished_ += bytes[static_cast<std::size_t>(i)];
        continue;
      }
      tell_(unfinished_);
      unfinished_.clear();
    }
    return true;
  }

 private:
  std::function<void(const std::string&)> tell_;
  std::string unfinished_;
};

/// Between fork and exec: only what a signal handler may do.
[[noreturn]] void become(char* const* words, int out, int err, int parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) ::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::execv(words[0], words);
  ::_exit(127);
}

void read_both(int out, int err, Lines& lines, Lines& errors) {
  std::array<pollfd, 2> both{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  while (both[0].fd >= 0 || both[1].fd >= 0) {
    if (::poll(both.data(), both.size(), -1) < 0 && errno != EINTR) return;
    for (std::size_t i = 0; i < both.size(); ++i)
      if (both[i].fd >= 0 && both[i].revents != 0 && !(i == 0 ? lines : errors).read(both[i].fd))
        both[i].fd = -1;
  }
}

}  // namespace

ChildProcess::Ending ChildProcess::run(const std::function<void(const std::string&)>& line) {
  std::vector<char*> words;
  for (std::string& word : words_) words.push_back(word.data());
  words.push_back(nullptr);
  Pipe out, err;
  const int parent = ::getpid();
  const int pid = ::fork();
  if (pid < 0) throw DeviceError(std::string("no process: ") + std::strerror(errno));
  if (pid == 0) become(words.data(), out.out.get(), err.out.get(), parent);
  pid_ = pid;
  if (stopped_) ::kill(pid, SIGTERM);
  out.out.reset(), err.out.reset();
  Ending ending;
  Lines lines(line), errors([&ending](const std::string&text) {
    ending.errors.push_back(text);
    if (ending.errors.size() > kMostErrorLines) ending.errors.erase(ending.errors.begin());
  });
  read_both(out.in.get(), err.in.get(), lines, errors);
  siginfo_t end{};
  while (::waitid(P_PID, static_cast<id_t>(pid), &end, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  pid_ = 0;  // before its number is free for another
  int status = 0;
  ::waitpid(pid, &status, 0);
  ending.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ending;
}

void ChildProcess::stop() {
  stopped_ = true;
  const int pid = pid_;
  if (pid > 0) ::kill(pid, SIGTERM);
}

}  // namespace rigsound::studio
