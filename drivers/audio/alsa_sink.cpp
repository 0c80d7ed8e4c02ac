#include "rigsound/audio/alsa_sink.hpp"

#include <algorithm>
#include <cerrno>

#include "audio/pcm.hpp"
#include "rigsound/audio/sample_format.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::audio {
namespace {

constexpr std::int64_t kFirstPause_ns = 100'000'000, kLongestPause_ns = 5'000'000'000;
constexpr int kMostAttempts = 8;  // recoveries for one block before the card counts as lost

std::string describe(const AudioOptions& options, const Granted& g) {
  return "sound card " + options.device + ": " + std::to_string(g.channels) + " channels, " +
         std::to_string(static_cast<long>(g.rate)) + " Hz, " + std::string(name(g.format)) + ", period " +
         std::to_string(g.period) + ", buffer " + std::to_string(g.buffer) + " frames";
}

}  // namespace

AlsaSink::AlsaSink(const AudioOptions& options, OpenPcm open, Clock& clock)
    : options_(options),
      open_(std::move(open)),
      clock_(clock),
      pacer_(clock, options.rate, options.block),
      wait_ms_(std::max(200, static_cast<int>(4e3 * options.block * options.periods / options.rate))),
      pause_ns_(kFirstPause_ns) {
  const auto samples = static_cast<std::size_t>(options_.block) * static_cast<std::size_t>(options_.channels);
  bytes_.resize(samples * sizeof(float));
  silence_.assign(bytes_.size(), 0);
  tend();
}

AlsaSink::AlsaSink(const AudioOptions& options, Clock& clock) : AlsaSink(options, open_alsa, clock) {}

AlsaSink::~AlsaSink() {
  delete pcm_;
  delete offered_.load();
  delete retired_.load();
}

void AlsaSink::count(CardEvent event) noexcept {
  events_[static_cast<std::size_t>(event)].fetch_add(1, std::memory_order_relaxed);
}

void AlsaSink::write(const float* block, std::uint64_t number) noexcept {
  if (!pcm_) take_offer();
  if (!pcm_) return pacer_.wait();
  const std::size_t samples =
      static_cast<std::size_t>(options_.block) * static_cast<std::size_t>(options_.channels);
  convert(block, samples, number * samples, pcm_->granted().format, bytes_.data());
  // The room is waited for here, not before the next write: the next block begins with the state of then.
  if (!play() || !make_room()) give_up();
}

void AlsaSink::take_offer() noexcept {
  pcm_ = offered_.exchange(nullptr, std::memory_order_acquire);
  if (!pcm_) return;
  frame_bytes_ = bytes_per_sample(pcm_->granted().format) * static_cast<std::size_t>(options_.channels);
  if (!restart()) give_up();
}

bool AlsaSink::play() noexcept {
  const auto frames = static_cast<unsigned long>(options_.block);
  unsigned long done = 0;
  for (int attempts = 0; done < frames;) {
    const long taken = pcm_->write(bytes_.data() + done * frame_bytes_, frames - done);
    if (taken > 0) {
      done += static_cast<unsigned long>(taken);
      if (done < frames) count(CardEvent::kShortWrite);
      attempts = 0;
      continue;
    }
    if (++attempts > kMostAttempts) return false;
    const bool full = taken == 0 || taken == -EAGAIN;
    if (full ? !make_room() : !recover(static_cast<int>(taken))) return false;
  }
  return true;
}

bool AlsaSink::make_room() noexcept {
  const int ready = pcm_->wait(wait_ms_);
  if (ready == 0) return false;  // the card's clock has stopped
  return ready > 0 || recover(ready);
}

bool AlsaSink::recover(int error) noexcept {
  switch (-error) {
    case EINTR:
      count(CardEvent::kInterrupted);
      return true;
    case EPIPE:
      count(CardEvent::kXrun);
      return restart();
    case EBADFD:
      count(CardEvent::kBadState);
      return restart();
    case ESTRPIPE:
      count(CardEvent::kSuspend);
      return pcm_->resume() == 0 || restart();
    default:
      return false;
  }
}

// The stream starts when its buffer is full: with this silence the next block starts it.
bool AlsaSink::restart() noexcept {
  if (pcm_->prepare() < 0) return false;
  const auto block = static_cast<unsigned long>(options_.block);
  for (unsigned long room = pcm_->granted().buffer; room >= 2 * block; room -= block)
    if (pcm_->write(silence_.data(), block) < 0) break;  // the block's own write meets the error again
  return true;
}

void AlsaSink::give_up() noexcept {
  count(CardEvent::kLost);
  retired_.store(pcm_, std::memory_order_release);
  pcm_ = nullptr;
  pacer_.start();
  playing_.store(false, std::memory_order_release);
}

void AlsaSink::tend() {
  if (playing_.load(std::memory_order_acquire)) return;
  delete retired_.exchange(nullptr,
                           std::memory_order_acquire);  // a raw card must be closed to be opened again
  const std::int64_t now = clock_.now_ns();
  if (now < next_try_ns_) return;
  try {
    std::unique_ptr<Pcm> pcm = open_(options_);
    description_ = describe(options_, pcm->granted());
    format_ = pcm->granted().format;
    pause_ns_ = kFirstPause_ns;
    next_try_ns_ = now + pause_ns_;
    playing_.store(true, std::memory_order_relaxed);
    offered_.store(pcm.release(), std::memory_order_release);
  } catch (const DeviceError& error) {
    description_ = error.what();
    next_try_ns_ = now + pause_ns_;
    pause_ns_ = std::min(2 * pause_ns_, kLongestPause_ns);
  }
}

CardStatus AlsaSink::status() const {
  CardStatus status;
  status.playing = playing_.load(std::memory_order_acquire);
  status.description = description_;
  status.format = format_;
  for (std::size_t i = 0; i < events_.size(); ++i)
    status.events[i] = events_[i].load(std::memory_order_relaxed);
  return status;
}

}  // namespace rigsound::audio
