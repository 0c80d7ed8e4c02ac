// The few things the sink asks of a playback stream, so that every error can be injected.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "rigsound/audio/audio_options.hpp"

namespace rigsound::audio {

/// What the card agreed to.
struct Granted {
  SampleFormat format = SampleFormat::kFloat;
  double rate = 0;  ///< Hz
  int channels = 0;
  unsigned long period = 0;  ///< frames
  unsigned long buffer = 0;  ///< frames
};

/// One open, configured stream. Non-blocking; errors are negative errno values, as libasound gives them.
/// Thread: RT, except destruction (CT).
class Pcm {
 public:
  virtual ~Pcm() = default;
  virtual const Granted& granted() const noexcept = 0;
  virtual long write(const void* frames, unsigned long count) noexcept = 0;  ///< frames taken, or error
  virtual int wait(int timeout_ms) noexcept = 0;  ///< 1: room for a period, 0: time is up, or error
  virtual int prepare() noexcept = 0;
  virtual int resume() noexcept = 0;
};

/// Opens a stream as the options ask; throws DeviceError naming the card and what it can do. Thread: CT.
using OpenPcm = std::function<std::unique_ptr<Pcm>(const AudioOptions&)>;

std::unique_ptr<Pcm> open_alsa(const AudioOptions& options);

}  // namespace rigsound::audio
