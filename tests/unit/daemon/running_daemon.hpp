// A daemon in this process, with a small rig and the line to its control socket.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "config/sound_set/example_bank.hpp"
#include "daemon.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "temporary_folder.hpp"

namespace rigsound::test {
namespace fs = std::filesystem;

inline config::SoundSetIndex all_situations(double gain_db) {
  config::SoundSetIndex index;
  for (int s = 0; s < kSituationCount; ++s) {
    config::BankEntry entry;
    entry.name = "a";
    entry.situation = static_cast<Situation>(s);
    entry.gain_db = gain_db;
    index.banks.push_back(entry);
  }
  return index;
}

/// A rig without card and bus whose sound set lies beside it.
struct SmallRig {
  SmallRig() {
    ClickBank bank = example_bank("a");
    bank.gain_db = -60;
    config::save_bank(folder.path / "set", bank, {});
    trim_db(0);
    write_rig("");
  }
  /// `more`: what stands below the sound and the socket.
  void write_rig(const std::string& more) const {
    folder.write("rig.toml", "[audio]\ndevice = \"null\"\n[sound]\nset = \"set\"\n[control]\nsocket = \"" +
                                 socket() + "\"\n" + more);
  }
  void trim_db(double gain_db) const {
    fs::remove(folder.path / "set/soundset.toml");
    config::merge_index(folder.path / "set", all_situations(gain_db));
  }
  std::string socket() const { return (folder.path / "c").string(); }

  TemporaryFolder folder;
};

/// A client of the control socket.
class Line {
 public:
  explicit Line(const std::string& path) : fd_(::socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, path.size());
    REQUIRE(::connect(fd_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  }
  void say(const nlohmann::json& request) const {
    const std::string line = request.dump() + "\n";
    REQUIRE(::send(fd_.get(), line.data(), line.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(line.size()));
  }
  nlohmann::json next() {
    std::size_t end = 0;
    char bytes[4096];
    while ((end = text_.find('\n')) == std::string::npos) {
      const ssize_t got = ::recv(fd_.get(), bytes, sizeof bytes, 0);
      REQUIRE(got > 0);
      text_.append(bytes, static_cast<std::size_t>(got));
    }
    nlohmann::json said = nlohmann::json::parse(text_.substr(0, end));
    text_.erase(0, end + 1);
    return said;
  }
  nlohmann::json ask(const nlohmann::json& request) {
    say(request);
    return next();
  }

 private:
  FileDescriptor fd_;
  std::string text_;
};

/// What the daemon answers to one request.
inline nlohmann::json ask(const std::string& path, const nlohmann::json& request) {
  return Line(path).ask(request);
}

inline nlohmann::json status(const std::string& path) { return ask(path, {{"command", "status"}}); }

/// The first status for which `holds`, or the last one after ten seconds.
template <class Condition>
nlohmann::json status_when(const std::string& socket, Condition holds) {
  nlohmann::json last = status(socket);
  for (int i = 0; i < 500 && !holds(last); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    last = status(socket);
  }
  return last;
}

/// Runs a daemon in a thread of its own until the end of the scope, as SIGTERM would end it.
struct Running {
  explicit Running(daemon::Daemon& daemon) {
    REQUIRE(::pipe2(signals, O_NONBLOCK | O_CLOEXEC) == 0);
    thread = std::thread([this, &daemon] { whole = daemon.run(signals[0]); });
  }
  ~Running() {
    if (thread.joinable()) end();
    ::close(signals[0]);
    ::close(signals[1]);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Whether nothing was left behind.
  bool end() {
    signalfd_siginfo info{};
    info.ssi_signo = SIGTERM;
    if (::write(signals[1], &info, sizeof info) != sizeof info) std::abort();
    thread.join();
    return whole;
  }

  int signals[2] = {-1, -1};
  bool whole = false;
  std::thread thread;
};

}  // namespace rigsound::test
