#include "audio/alsa_sink.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "rigsound/audio/sample_format.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::audio {
namespace {

constexpr int kMostAttempts = 8;                // recoveries for one block before the card counts as lost
constexpr std::int64_t kWorks_ms = 5000;        // a card that played for so long is looked for at once
constexpr std::int64_t kClockless_ms = 60'000;  // one without a clock only now and then
constexpr int kFirstOpen_ms = 1000;             // is waited for: the sound begins with the card
constexpr std::int64_t kHangs_ms = 2000;        // a device that takes longer is told

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
      wait_ms_(std::max(200, static_cast<int>(4e3 * options.block * options.periods / options.rate))) {
  bytes_.resize(samples() * sizeof(float));
  silence_.assign(bytes_.size(), 0);
  poll();
  job_.wait(kFirstOpen_ms);
  poll();
}

std::unique_ptr<SoundCard> make_sound_card(const AudioOptions& options, Clock& clock) {
  return std::make_unique<AlsaSink>(options, open_alsa, clock);
}

std::int64_t AlsaSink::now_ms() noexcept { return clock_.now_ns() / 1'000'000; }

void AlsaSink::count(CardEvent event) noexcept {
  events_[static_cast<std::size_t>(event)].fetch_add(1, std::memory_order_relaxed);
}

void AlsaSink::write(const float* block, std::uint64_t number) noexcept {
  if (!pcm_ && !take_stream()) return pacer_.wait();
  convert(block, samples(), number * samples(), pcm_->granted().format, bytes_.data());
  // The room is waited for here, not before the next write: the next block begins with the state of then.
  if (!play() || !make_room()) return give_up(0);
  const std::int64_t now_ns = clock_.now_ns();
  if (pace_.taken(now_ns)) return;
  clockless_.store(true, std::memory_order_relaxed);
  give_up(static_cast<std::int64_t>(pace_.ahead_ns(now_ns)));
}

/// False: there is no stream, or it does not start.
bool AlsaSink::take_stream() noexcept {
  if (!streams_.swap(pcm_)) return false;
  const Granted& granted = pcm_->granted();
  frame_bytes_ = bytes_per_sample(granted.format) * options_.channels;
  const double frame_ns = 1e9 / options_.rate;
  pace_.start(clock_.now_ns(), options_.block * frame_ns, static_cast<double>(granted.buffer) * frame_ns);
  if (restart()) return true;
  give_up(0);
  return false;
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

/// The block clock waits for the time that it is ahead of.
void AlsaSink::give_up(std::int64_t ahead_ns) noexcept {
  count(CardEvent::kLost);
  streams_.retire(pcm_);  // there is room: poll() offers a stream only after it has closed the last one
  pacer_.start(ahead_ns);
  playing_.store(false, std::memory_order_release);
}

void AlsaSink::poll() {
  if (playing_.load(std::memory_order_acquire)) return;
  const std::int64_t now = now_ms();
  if (job_.busy()) {
    std::optional<Outcome> outcome = job_.take();
    if (!outcome) {
      if (now - begun_ms_ >= kHangs_ms)
        description_ = "sound card " + options_.device + ": does not answer, it is being " + doing_;
      return;
    }
    take(std::move(*outcome), now);
    if (playing_.load(std::memory_order_relaxed)) return;
  }
  // A raw card must be closed to be opened again.
  if (std::unique_ptr<Pcm> given_up = streams_.collect()) return put_away(std::move(given_up), now);
  if (backoff_.due(now) && now >= not_before_ms_) open(now);
}

void AlsaSink::begin(std::function<Outcome()> work, const char* doing, std::int64_t now) {
  doing_ = doing;
  begun_ms_ = now;
  job_.begin(std::move(work));
}

void AlsaSink::open(std::int64_t now) {
  const auto work = [open = open_, options = options_]() -> Outcome {
    try {
      return {open(options), {}};
    } catch (const DeviceError& error) {
      return {nullptr, error.what()};
    }
  };
  begin(work, "opened", now);
}

void AlsaSink::take(Outcome outcome, std::int64_t now) {
  if (!outcome.error.empty()) {
    description_ = outcome.error;
    backoff_.failed(now);
  }
  if (!outcome.pcm) return;
  description_ = describe(options_, outcome.pcm->granted());
  format_ = outcome.pcm->granted().format;
  opened_ms_ = now;
  playing_.store(true, std::memory_order_relaxed);
  streams_.offer(std::move(outcome.pcm));
}

void AlsaSink::put_away(std::unique_ptr<Pcm> pcm, std::int64_t now) {
  now - opened_ms_ >= kWorks_ms ? backoff_.worked(now) : backoff_.failed(now);
  begin(
      [closed = std::shared_ptr<Pcm>(std::move(pcm))]() mutable -> Outcome {
        closed.reset();
        return {};
      },
      "closed", now);
  if (!clockless_.exchange(false, std::memory_order_relaxed)) return;
  description_ =
      "sound card " + options_.device + ": takes blocks faster than it can play them, it has no clock";
  not_before_ms_ = now + kClockless_ms;
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
