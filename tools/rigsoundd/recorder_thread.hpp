// The recorder on a thread of its own: a disk may be slow, or not answer at all.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "recorder.hpp"
#include "rigsound/bus/stop_event.hpp"

namespace rigsound::daemon {

/// How the recorder stood when it was last heard of.
struct RecorderStatus {
  std::uint32_t run = 0;  ///< that it speaks of
  bool recording = false;
  audio::SampleFormat format = audio::SampleFormat::kAuto;  ///< of the session
  std::string_view wants_new_run;                           ///< why; empty: none is due
  std::string problem;
  std::uint64_t bytes = 0;
  std::filesystem::path file;
};

/// Polls a recorder ten times a second. No call here waits for it. Thread: CT.
class RecorderThread {
 public:
  /// As those of Recorder, which must both outlive the thread: see finish().
  RecorderThread(std::optional<session::SessionFolder> folder, RunQueue& records,
                 const AudioFigures& figures);
  ~RecorderThread() { finish(); }
  RecorderThread(const RecorderThread&) = delete;
  RecorderThread& operator=(const RecorderThread&) = delete;

  void expect_run(const session::SessionHeader& header) { recorder_.expect_run(header); }
  void give_up(const std::string& why);  ///< soon
  void set_silent_s(double silent_s) { silent_s_.store(silent_s, std::memory_order_relaxed); }
  RecorderStatus status() const;

  /// Takes the rest; the audio thread must have stopped. False: the disk has not answered within 0.3 s, and
  /// the thread ends with the process only.
  bool finish();

 private:
  void loop();
  void publish();

  Recorder recorder_;  // the thread's, but for expect_run()
  std::atomic<double> silent_s_{0};
  mutable std::mutex exchanging_;  // held for a copy only
  RecorderStatus status_;
  std::string to_give_up_;
  StopEvent stop_, done_;
  std::thread thread_;
};

}  // namespace rigsound::daemon
