#include "rigsound/audio/clock.hpp"

#include <cerrno>
#include <ctime>

namespace rigsound::audio {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

}  // namespace

std::int64_t MonotonicClock::now_ns() noexcept {
  timespec t{};
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * kSecond_ns + t.tv_nsec;
}

void MonotonicClock::sleep_until_ns(std::int64_t when) noexcept {
  const timespec t{when / kSecond_ns, when % kSecond_ns};
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

Pacer::Pacer(Clock& clock, double rate_hz, int block_frames)
    : clock_(clock), block_ns_(block_frames * 1e9 / rate_hz) {
  start();
}

void Pacer::start(std::int64_t ahead_ns) noexcept {
  origin_ns_ = clock_.now_ns() + ahead_ns;
  blocks_ = 0;
}

void Pacer::wait() noexcept {
  ++blocks_;
  const std::int64_t due = origin_ns_ + static_cast<std::int64_t>(static_cast<double>(blocks_) * block_ns_);
  if (clock_.now_ns() - due > kSecond_ns) return start();
  clock_.sleep_until_ns(due);
}

}  // namespace rigsound::audio
