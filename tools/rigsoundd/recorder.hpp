// Writes sessions while the daemon runs; whatever happens to them, the sound goes on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "audio_figures.hpp"
#include "rigsound/session/session_folder.hpp"
#include "rigsound/session/session_writer.hpp"
#include "run_record.hpp"

namespace rigsound::daemon {

/// Each run is one session. Thread: one at a time, where nothing else is said.
class Recorder {
 public:
  /// Without a folder nothing is recorded.
  Recorder(std::optional<session::SessionFolder> folder, RunQueue& records, const AudioFigures& figures)
      : folder_(std::move(folder)), records_(records), figures_(figures) {}

  /// What the next run that is offered is rendered with; must be called before it begins, once each. Thread:
  /// any
  void expect_run(const session::SessionHeader& header);
  const session::SessionHeader& header() const { return header_; }  ///< of the run being recorded

  /// Takes what the audio thread left; at least once a second it is handed to the kernel.
  void poll(double now_s);
  void finish();  ///< takes the rest; the audio thread must have stopped

  /// Why a new run is due: the session "is full", "has lost a record" or "was interrupted for over an hour";
  /// empty: none is. `silent_s`: how long there has been no sound; from 2 s on a new run disturbs nobody, and
  /// half of its share of the limit makes it full.
  std::string_view wants_new_run(double silent_s) const;

  void give_up(const std::string& why);  ///< this run is recorded no further

  /// What is said here is true of this run: the last that began, or any whose record was lost.
  std::uint32_t run() const {
    return broken() ? figures_.run.load(std::memory_order_relaxed) : run_.value_or(0);
  }
  bool recording() const { return writer_ != nullptr; }
  const std::string& problem() const { return problem_; }
  std::uint64_t bytes() const { return writer_ ? writer_->bytes() : 0; }
  const std::filesystem::path& file() const { return file_; }  ///< of the last session; empty: none yet

 private:
  session::SessionHeader take_expected(std::uint32_t run);
  void take(const RunRecord& record);
  void begin(const RunRecord& first);
  void drain();
  void skip(const RunRecord& record);
  bool broken() const;  // a change of state of this run was lost

  std::optional<session::SessionFolder> folder_;
  RunQueue& records_;
  const AudioFigures& figures_;
  std::mutex expecting_;
  std::map<std::uint32_t, session::SessionHeader> expected_;  // runs that have not begun
  std::uint32_t next_run_ = 0;
  session::SessionHeader header_;
  std::unique_ptr<session::SessionWriter> writer_;
  std::filesystem::path file_;
  std::optional<std::uint32_t> run_;
  std::uint64_t lost_at_begin_ = 0;
  double next_flush_s_ = 0;
  std::string problem_;
  bool interrupted_ = false;
};

}  // namespace rigsound::daemon
