// The sound card: plays while there is one, keeps the block clock going while there is none.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "rigsound/audio/audio_options.hpp"
#include "rigsound/audio/clock.hpp"
#include "rigsound/audio/sink.hpp"

namespace rigsound::audio {

/// What went wrong on the card so far, each kind by itself.
enum class CardEvent : std::uint8_t { kXrun, kSuspend, kBadState, kShortWrite, kInterrupted, kLost };
constexpr int kCardEventCount = 6;

struct CardStatus {
  bool playing = false;                                 ///< a card is open
  std::string description;                              ///< what was granted, or why there is no card
  SampleFormat format = SampleFormat::kAuto;            ///< of the card; kAuto before the first one was found
  std::array<std::uint64_t, kCardEventCount> events{};  ///< by CardEvent
};

/// write() never waits for anything but room in the card's buffer (Thread: RT); opening and closing a card
/// takes time, with some for ever, so a thread of its own does it.
class SoundCard : public Sink {
 public:
  /// Has a card that was given up closed, and one looked for while there is none: at once, then with pauses
  /// of 0.1 s doubling to 5 s. Waits for neither. Call about ten times a second. Thread: CT.
  virtual void poll() = 0;

  /// A card is being opened or closed: by a thread that goes on when this is destroyed. Thread: as poll()
  virtual bool busy() const = 0;

  virtual CardStatus status() const = 0;  ///< Thread: CT, the one that calls poll()
};

/// Tries to open the ALSA device of the options and waits for that, a second at most; a missing card is no
/// error. Thread: OFF.
std::unique_ptr<SoundCard> make_sound_card(const AudioOptions& options, Clock& clock);

}  // namespace rigsound::audio
