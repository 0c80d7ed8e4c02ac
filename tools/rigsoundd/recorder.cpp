#include "recorder.hpp"

#include <chrono>

#include "log.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::daemon {
namespace {

constexpr double kFlush_s = 0.5;
constexpr double kSilence_s = 2;

}  // namespace

void Recorder::expect_run(const session::SessionHeader& header) {
  const std::lock_guard<std::mutex> lock(expecting_);
  expected_[next_run_++] = header;
}

session::SessionHeader Recorder::take_expected(std::uint32_t run) {
  const std::lock_guard<std::mutex> lock(expecting_);
  session::SessionHeader header = expected_[run];
  expected_.erase(expected_.begin(), expected_.upper_bound(run));
  return header;
}

void Recorder::give_up(const std::string& why) {
  problem_ = why;
  interrupted_ = false;
  writer_.reset();
  log_error(why + "; the sound goes on, this run is no longer recorded");
}

void Recorder::begin(const RunRecord& first) {
  run_ = first.run;
  header_ = take_expected(first.run);
  problem_.clear();
  interrupted_ = false;
  lost_at_begin_ = first.lost;
  writer_.reset();
  if (!folder_) return;
  try {
    writer_ = folder_->begin(header_, std::chrono::system_clock::now());
    file_ = writer_->file();
    log_info("session: " + file_.string());
  } catch (const DeviceError& error) {
    give_up(error.what());
  }
}

void Recorder::take(const RunRecord& record) {
  if (record.kind == RunRecord::Kind::kChange && record.block == 0) begin(record);
  if (!writer_ || run_ != record.run) return;
  if (record.kind == RunRecord::Kind::kChange) return writer_->add(record.block, record.state);
  if (record.kind == RunRecord::Kind::kSkip) return skip(record);
  if (!broken()) writer_->end(record.block);
  writer_.reset();
}

/// A night's sleep is no part of a run.
void Recorder::skip(const RunRecord& record) {
  const double skipped_s = static_cast<double>(record.skipped) * header_.block / header_.sample_rate;
  interrupted_ = skipped_s > session::kLongestSkip_s;
  if (!interrupted_) return writer_->skip(record.block, record.skipped);
  writer_->end(record.block);
  writer_.reset();
}

bool Recorder::broken() const {
  return figures_.lost_records.load(std::memory_order_relaxed) != lost_at_begin_;
}

void Recorder::drain() {
  RunRecord record;
  try {
    while (records_.try_dequeue(record)) take(record);
  } catch (const DeviceError& error) {
    give_up(error.what());
  }
}

// The blocks counted before the queue is emptied are all covered by what was in it.
void Recorder::poll(double now_s) {
  const std::uint32_t run = figures_.run.load(std::memory_order_acquire);
  const std::uint64_t blocks = figures_.run_blocks.load(std::memory_order_acquire);
  drain();
  if (!writer_ || run_ != run || broken() || blocks == 0 || now_s < next_flush_s_) return;
  next_flush_s_ = now_s + kFlush_s;
  try {
    writer_->flush(blocks);
  } catch (const DeviceError& error) {
    give_up(error.what());
  }
}

void Recorder::finish() { drain(); }

std::string_view Recorder::wants_new_run(double silent_s) const {
  if (interrupted_) return "was interrupted for over an hour";
  if (!writer_) return {};
  if (broken()) return "has lost a record";
  const std::uint64_t share = folder_->share();
  return writer_->bytes() > (silent_s > kSilence_s ? share / 2 : share) ? "is full" : std::string_view();
}

}  // namespace rigsound::daemon
