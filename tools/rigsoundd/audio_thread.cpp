#include "audio_thread.hpp"

#include <pthread.h>
#include <sched.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {
namespace {

constexpr int kPriority = 70;
constexpr std::size_t kStackTouched = 128 * 1024;

using SteadyClock = std::chrono::steady_clock;

// The first touch of a page of stack must not happen while rendering.
void touch_stack() {
  std::array<volatile char, kStackTouched> stack;
  for (volatile char& byte : stack) byte = 0;
}

template <typename T>
void raise(std::atomic<T>& counter, T by) noexcept {
  counter.store(counter.load(std::memory_order_relaxed) + by, std::memory_order_relaxed);
}

}  // namespace

AudioThread::AudioThread(std::unique_ptr<Engine> engine, audio::Sink& sink, TripleBuffer<StateInput>& states)
    : engine_(std::move(engine)),
      block_(audio::make_block(engine_->options())),
      deadline_ns_(
          static_cast<std::uint64_t>(engine_->options().block * 1e9 / engine_->options().sample_rate)),
      sink_(sink),
      states_(states),
      ear_(engine_->options().sample_rate, engine_->options().channels),
      jumps_(static_cast<std::int64_t>(deadline_ns_)) {
  window_.number = 1;
}

AudioThread::~AudioThread() { stop(); }

void AudioThread::start() {
  thread_ = std::thread([this] { loop(); });
  while (!ready_.load(std::memory_order_acquire)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void AudioThread::stop() {
  stop_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
}

void AudioThread::ask_scheduler() {
  const sched_param param{kPriority};
  const int error = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &param);
  scheduling_ = error == 0 ? "SCHED_FIFO " + std::to_string(kPriority)
                           : std::string("normal priority, SCHED_FIFO refused: ") + std::strerror(error);
}

void AudioThread::loop() {
  ask_scheduler();
  touch_stack();
  ready_.store(true, std::memory_order_release);
  while (!stop_.load(std::memory_order_relaxed)) {
    begin_run();
    render_run();
  }
}

void AudioThread::begin_run() {
  if (!next_engine_.swap(engine_)) return;
  figures_.run_blocks.store(0, std::memory_order_relaxed);
  figures_.run.store(figures_.run.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

// As audio::run_blocks() renders offline, but that it measures each block and ends for a new engine.
void AudioThread::render_run() {
  const std::uint32_t run = figures_.run.load(std::memory_order_relaxed);
  std::uint64_t number = 0;
  while (!stop_.load(std::memory_order_relaxed) && !next_engine_.offered()) {
    note_jump(run, number);
    const auto begin = SteadyClock::now();
    const MachineState& state = states_.at(monotonic_s());
    if (reporter_.report(run, number, state)) heard_.write(state);
    engine_->process(state, block_.data());
    measure(static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::nanoseconds>(SteadyClock::now() - begin).count()));
    sink_.write(block_.data(), number++);
    raise<std::uint64_t>(figures_.blocks, 1);
    figures_.run_blocks.store(number, std::memory_order_release);
  }
  reporter_.report_end(run, number);
}

void AudioThread::note_jump(std::uint32_t run, std::uint64_t number) noexcept {
  const std::uint64_t skipped = jumps_.skipped(boottime_ns());
  if (skipped == 0) return;
  raise<std::uint64_t>(figures_.clock_jumps, 1);
  raise<std::uint64_t>(figures_.skipped_blocks, skipped);
  if (number > 0) reporter_.report_skip(run, number, skipped);
}

void AudioThread::measure(std::uint64_t spent_ns) noexcept {
  if (spent_ns > figures_.worst_ns.load(std::memory_order_relaxed))
    figures_.worst_ns.store(spent_ns, std::memory_order_relaxed);
  raise<std::uint64_t>(figures_.measured, 1);
  figures_.busy_ns.store(figures_.busy_ns.load(std::memory_order_relaxed) + spent_ns,
                         std::memory_order_release);
  if (spent_ns > deadline_ns_) raise<std::uint64_t>(figures_.deadline_misses, 1);
  const EngineMeters meters = engine_->meters();
  figures_.peak.store(meters.peak, std::memory_order_relaxed);
  figures_.lost_clicks.store(meters.lost_clicks, std::memory_order_relaxed);
  figures_.dropped_chunks.store(meters.dropped_chunks, std::memory_order_relaxed);
  report_levels(meters);
}

void AudioThread::report_levels(const EngineMeters& meters) noexcept {
  window_.add(meters, engine_->view());
  if (measures_sound_.load(std::memory_order_relaxed)) {
    ear_.process(block_.data(), engine_->options().block);
    window_.sound.add(ear_.level());
  }
  if (window_to_close_.load(std::memory_order_relaxed) == window_.number) {
    next_report_.closed = window_;
    window_ = {};
    window_.number = next_report_.closed.number + 1;
  }
  next_report_.view = engine_->view();
  report_.write(next_report_);
}

}  // namespace rigsound::daemon
