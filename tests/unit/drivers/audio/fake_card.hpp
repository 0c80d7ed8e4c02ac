// A sound card whose every answer is written down beforehand, and a clock that jumps.
#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "audio/pcm.hpp"
#include "rigsound/audio/clock.hpp"

namespace rigsound::audio {

class FakeClock : public Clock {
 public:
  std::int64_t now_ns() noexcept override { return now; }
  void sleep_until_ns(std::int64_t when) noexcept override {
    if (when > now) now = when;
    ++sleeps;
  }
  std::int64_t now = 1'000'000'000;
  int sleeps = 0;
};

/// What the card heard and what it shall answer; outlives the streams opened on it.
struct FakeCard {
  std::vector<float> heard;     // every frame accepted, mono float
  std::map<int, long> at;       // what the k-th write call answers: an error, or the frames it takes
  std::map<int, int> waits_at;  // what the k-th wait answers instead of wait_answer
  int writes = 0, waits = 0, prepares = 0, resumes = 0, open_streams = 0;
  int wait_answer = 1, prepare_answer = 0, resume_answer = 0;
  bool present = true;
  std::mutex answers;  // held: opening and closing hang
};

class FakePcm : public Pcm {
 public:
  FakePcm(FakeCard& card, const AudioOptions& options) : card_(card) {
    granted_.format = SampleFormat::kFloat;
    granted_.rate = options.rate;
    granted_.channels = options.channels;
    granted_.period = static_cast<unsigned long>(options.block);
    granted_.buffer = granted_.period * static_cast<unsigned long>(options.periods);
    ++card_.open_streams;
  }
  ~FakePcm() override {
    const std::lock_guard<std::mutex> answered(card_.answers);
    --card_.open_streams;
  }

  const Granted& granted() const noexcept override { return granted_; }
  long write(const void* frames, unsigned long count) noexcept override {
    const auto script = card_.at.find(card_.writes++);
    if (script != card_.at.end()) {
      if (script->second < 0) return script->second;
      count = static_cast<unsigned long>(script->second);
    }
    const auto* samples = static_cast<const float*>(frames);
    card_.heard.insert(card_.heard.end(), samples, samples + count);
    return static_cast<long>(count);
  }
  int wait(int) noexcept override {
    const auto script = card_.waits_at.find(card_.waits++);
    return script != card_.waits_at.end() ? script->second : card_.wait_answer;
  }
  int prepare() noexcept override { return ++card_.prepares, card_.prepare_answer; }
  int resume() noexcept override { return ++card_.resumes, card_.resume_answer; }

 private:
  FakeCard& card_;
  Granted granted_;
};

}  // namespace rigsound::audio
