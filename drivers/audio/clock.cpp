#include "rigsound/audio/clock.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace rigsound::audio {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr double kGroup_ns = 10e6;

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
    : clock_(clock),
      block_ns_(block_frames * 1e9 / rate_hz),
      group_(std::max<std::int64_t>(1, static_cast<std::int64_t>(kGroup_ns / block_ns_))) {
  start();
}

void Pacer::start(std::int64_t ahead_ns) noexcept {
  origin_ns_ = clock_.now_ns() + ahead_ns;
  blocks_ = 0;
}

void Pacer::wait() noexcept {
  if (++blocks_ % group_ != 0) return;
  const std::int64_t due = origin_ns_ + static_cast<std::int64_t>(static_cast<double>(blocks_) * block_ns_);
  // The blocks of this group began together: all but one were ahead of their time.
  if (clock_.now_ns() - due > kSecond_ns)
    return start(static_cast<std::int64_t>(static_cast<double>(group_ - 1) * block_ns_));
  clock_.sleep_until_ns(due);
}

}  // namespace rigsound::audio
