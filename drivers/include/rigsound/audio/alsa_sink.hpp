// The sound card: plays while there is one, keeps the block clock going while there is none.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/audio/audio_options.hpp"
#include "rigsound/audio/clock.hpp"
#include "rigsound/audio/sink.hpp"

namespace rigsound::audio {

class Pcm;

/// What went wrong on the card so far, each kind by itself.
enum class CardEvent : std::uint8_t { kXrun, kSuspend, kBadState, kShortWrite, kInterrupted, kLost };
constexpr int kCardEventCount = 6;

struct CardStatus {
  bool playing = false;                                 ///< a card is open
  std::string description;                              ///< what was granted, or why there is no card
  SampleFormat format = SampleFormat::kAuto;            ///< of the card; kAuto before the first one was found
  std::array<std::uint64_t, kCardEventCount> events{};  ///< by CardEvent
};

/// Errors are handled one by one: EPIPE and EBADFD prepare the stream again, ESTRPIPE resumes it once,
/// anything that says the card is gone (or takes no samples for several buffers) gives it up. Every block
/// goes to the card once and in order, after silence that fills the buffer whenever the stream starts
/// anew. Opening and closing a card takes time, so the audio thread never does it: tend() does.
class AlsaSink : public Sink {
 public:
  /// Tries to open the card at once; a missing card is no error. Thread: OFF.
  AlsaSink(const AudioOptions& options, Clock& clock);
  /// The same with another way to open a card, for tests.
  AlsaSink(const AudioOptions& options, std::function<std::unique_ptr<Pcm>(const AudioOptions&)> open,
           Clock& clock);
  ~AlsaSink() override;
  AlsaSink(const AlsaSink&) = delete;
  AlsaSink& operator=(const AlsaSink&) = delete;

  void write(const float* block, std::uint64_t number) noexcept override;  ///< Thread: RT

  /// Closes a card given up, looks for one while there is none: at once, then with pauses of 0.1 s
  /// doubling to 5 s. Call about ten times a second. Thread: CT.
  void tend();

  CardStatus status() const;  ///< Thread: CT, the one that calls tend()

 private:
  void take_offer() noexcept;
  bool play() noexcept;
  bool make_room() noexcept;
  bool recover(int error) noexcept;
  bool restart() noexcept;
  void give_up() noexcept;
  void count(CardEvent event) noexcept;

  AudioOptions options_;
  std::function<std::unique_ptr<Pcm>(const AudioOptions&)> open_;
  Clock& clock_;
  Pacer pacer_;
  std::vector<unsigned char> bytes_, silence_;  // one block in the card's format
  std::size_t frame_bytes_ = 0;
  int wait_ms_ = 0;
  Pcm* pcm_ = nullptr;  // the audio thread's

  std::atomic<Pcm*> offered_{nullptr}, retired_{nullptr};  // CT -> RT, RT -> CT
  std::atomic<bool> playing_{false};
  std::array<std::atomic<std::uint64_t>, kCardEventCount> events_{};

  std::string description_;
  SampleFormat format_ = SampleFormat::kAuto;
  std::int64_t next_try_ns_ = 0, pause_ns_ = 0;
};

}  // namespace rigsound::audio
