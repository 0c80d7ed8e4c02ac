// Blocks onto an ALSA stream, every error of which has its own answer.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "audio/pace_watch.hpp"
#include "audio/pcm.hpp"
#include "backoff.hpp"
#include "rigsound/audio/sound_card.hpp"
#include "rigsound/handoff/background_job.hpp"
#include "rigsound/handoff/swap_slot.hpp"

namespace rigsound::audio {

/// EPIPE and EBADFD prepare the stream again, ESTRPIPE resumes it once, anything that says the card is gone
/// (or takes no samples for several buffers, or takes them faster than it can play) gives it up. Every block
/// goes to the card once and in order, after silence that fills the buffer whenever the stream starts anew.
class AlsaSink final : public SoundCard {
 public:
  /// `open`: open_alsa(), or what a test puts in its place. Thread: OFF.
  AlsaSink(const AudioOptions& options, OpenPcm open, Clock& clock);

  void write(const float* block, std::uint64_t number) noexcept override;
  void poll() override;
  bool busy() const override { return job_.busy(); }
  CardStatus status() const override;

 private:
  bool take_stream() noexcept;
  bool play() noexcept;
  bool make_room() noexcept;
  bool recover(int error) noexcept;
  bool restart() noexcept;
  void give_up(std::int64_t ahead_ns) noexcept;
  /// A card that was opened; neither: one that was closed.
  struct Outcome {
    std::unique_ptr<Pcm> pcm;
    std::string error;
  };

  void begin(std::function<Outcome()> work, const char* doing, std::int64_t now_ms);
  void take(Outcome outcome, std::int64_t now_ms);
  void open(std::int64_t now_ms);
  void put_away(std::unique_ptr<Pcm> pcm, std::int64_t now_ms);
  void count(CardEvent event) noexcept;
  std::int64_t now_ms() noexcept;
  std::size_t samples() const { return options_.block * options_.channels; }

  AudioOptions options_;
  OpenPcm open_;
  Clock& clock_;
  Pacer pacer_;
  std::vector<unsigned char> bytes_, silence_;  // one block in the card's format
  std::size_t frame_bytes_ = 0;
  int wait_ms_ = 0;
  std::unique_ptr<Pcm> pcm_;  // the audio thread's
  PaceWatch pace_;

  SwapSlot<Pcm> streams_;  // opened for poll(), played by the audio thread, closed for poll()
  std::atomic<bool> playing_{false};
  std::atomic<bool> clockless_{false};  // why the last stream was given up
  std::array<std::atomic<std::uint64_t>, kCardEventCount> events_{};

  std::string description_;
  SampleFormat format_ = SampleFormat::kAuto;
  Backoff backoff_;
  std::int64_t opened_ms_ = 0, not_before_ms_ = 0;
  BackgroundJob<Outcome> job_;
  const char* doing_ = "";
  std::int64_t begun_ms_ = 0;
};

}  // namespace rigsound::audio
