#include "recorder_thread.hpp"

#include <utility>

#include "log.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {
namespace {

constexpr int kRound_ms = 100, kPatience_ms = 300;

}  // namespace

RecorderThread::RecorderThread(std::optional<session::SessionFolder> folder, RunQueue& records,
                               const AudioFigures& figures)
    : recorder_(std::move(folder), records, figures), thread_([this] { loop(); }) {}

void RecorderThread::loop() {
  while (!stop_.is_set()) {
    recorder_.poll(monotonic_s());
    publish();
    stop_.wait(-1, 0, kRound_ms);
  }
  recorder_.finish();
  publish();
  done_.set();
}

void RecorderThread::publish() {
  std::string why;
  {
    const std::lock_guard<std::mutex> lock(exchanging_);
    why = std::exchange(to_give_up_, {});
  }
  if (!why.empty()) recorder_.give_up(why);
  RecorderStatus now;
  now.run = recorder_.run();
  now.recording = recorder_.recording();
  now.format = recorder_.header().format;
  now.wants_new_run = recorder_.wants_new_run(silent_s_.load(std::memory_order_relaxed));
  now.problem = recorder_.problem();
  now.bytes = recorder_.bytes();
  now.file = recorder_.file();
  const std::lock_guard<std::mutex> lock(exchanging_);
  status_ = std::move(now);
}

void RecorderThread::give_up(const std::string& why) {
  const std::lock_guard<std::mutex> lock(exchanging_);
  to_give_up_ = why;
}

RecorderStatus RecorderThread::status() const {
  const std::lock_guard<std::mutex> lock(exchanging_);
  return status_;
}

bool RecorderThread::finish() {
  if (!thread_.joinable()) return done_.is_set();
  stop_.set();
  done_.wait(-1, 0, kPatience_ms);
  if (done_.is_set()) {
    thread_.join();
    return true;
  }
  log_error("session: the disk does not answer, the session is not ended");
  thread_.detach();
  return false;
}

}  // namespace rigsound::daemon
