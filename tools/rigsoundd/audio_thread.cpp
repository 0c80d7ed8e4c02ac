#include "audio_thread.hpp"

#include <pthread.h>
#include <sched.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace rigsound::daemon {
namespace {

constexpr int kPriority = 70;
constexpr std::size_t kStackTouched = 128 * 1024;

using SteadyClock = std::chrono::steady_clock;

// The first touch of a page of stack must not happen while rendering.
void touch_stack() {
  std::array<volatile char, kStackTouched> pages;
  for (std::size_t i = 0; i < pages.size(); i += 4096) pages[i] = 0;
}

template <typename T>
void raise(std::atomic<T>& counter, T by) noexcept {
  counter.store(counter.load(std::memory_order_relaxed) + by, std::memory_order_relaxed);
}

}  // namespace

class AudioThread::States : public audio::StateSource {
 public:
  States(AudioThread& thread, std::uint32_t run) : thread_(thread), run_(run) {}

  const MachineState* state_of(std::uint64_t number) override {
    if (thread_.stop_.load(std::memory_order_relaxed) ||
        thread_.offered_.load(std::memory_order_relaxed) != nullptr)
      return nullptr;
    const MachineState& newest = thread_.states_.read();
    if (number == 0 || std::memcmp(&newest, &state_, sizeof state_) != 0) {
      std::memcpy(&state_, &newest, sizeof state_);
      thread_.tell({RunRecord::Kind::kChange, run_, number, state_, 0});
    }
    started_ = SteadyClock::now();
    return &state_;
  }

  SteadyClock::time_point started() const { return started_; }

 private:
  AudioThread& thread_;
  std::uint32_t run_;
  MachineState state_;
  SteadyClock::time_point started_;
};

class AudioThread::Timed : public audio::Sink {
 public:
  Timed(AudioThread& thread, const States& states)
      : thread_(thread),
        states_(states),
        deadline_ns_(static_cast<std::uint64_t>(thread.engine_->options().block * 1e9 /
                                                thread.engine_->options().sample_rate)) {}

  void write(const float* block, std::uint64_t number) override {
    measure();
    thread_.sink_.write(block, number);
    raise<std::uint64_t>(thread_.figures_.blocks, 1);
    thread_.figures_.run_blocks.store(number + 1, std::memory_order_release);
  }

 private:
  void measure() noexcept {
    AudioFigures& f = thread_.figures_;
    const auto spent = static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::nanoseconds>(SteadyClock::now() - states_.started()).count());
    raise(f.busy_ns, spent);
    if (spent > f.worst_ns.load(std::memory_order_relaxed))
      f.worst_ns.store(spent, std::memory_order_relaxed);
    if (spent > deadline_ns_) raise<std::uint64_t>(f.deadline_misses, 1);
    const EngineMeters meters = thread_.engine_->meters();
    f.peak.store(meters.peak, std::memory_order_relaxed);
    f.rms.store(meters.rms, std::memory_order_relaxed);
    f.limiter_gain.store(meters.limiter_gain, std::memory_order_relaxed);
    f.lost_clicks.store(meters.lost_clicks, std::memory_order_relaxed);
  }

  AudioThread& thread_;
  const States& states_;
  std::uint64_t deadline_ns_;
};

AudioThread::AudioThread(std::unique_ptr<Engine> engine, audio::Sink& sink,
                         TripleBuffer<MachineState>& states)
    : engine_(std::move(engine)),
      block_(audio::make_block(engine_->options())),
      sink_(sink),
      states_(states) {}

AudioThread::~AudioThread() {
  stop();
  delete offered_.load();
  delete retired_.load();
}

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
    States states(*this, figures_.run.load(std::memory_order_relaxed));
    Timed timed(*this, states);
    end_run(audio::run_blocks(*engine_, states, timed, block_));
  }
}

void AudioThread::begin_run() {
  Engine* const next = offered_.exchange(nullptr, std::memory_order_acquire);
  if (next == nullptr) return;
  retired_.store(engine_.release(), std::memory_order_release);
  engine_.reset(next);
  figures_.run_blocks.store(0, std::memory_order_relaxed);
  figures_.run.store(figures_.run.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

void AudioThread::end_run(std::uint64_t blocks) {
  tell({RunRecord::Kind::kEnd, figures_.run.load(std::memory_order_relaxed), blocks, {}, 0});
}

void AudioThread::tell(RunRecord record) noexcept {
  record.lost = figures_.lost_records.load(std::memory_order_relaxed);
  if (!records_.try_enqueue(record)) raise<std::uint64_t>(figures_.lost_records, 1);
}

void AudioThread::replace_engine(std::unique_ptr<Engine> engine) {
  offered_.store(engine.release(), std::memory_order_release);
  Engine* old = nullptr;
  while ((old = retired_.exchange(nullptr, std::memory_order_acquire)) == nullptr && thread_.joinable())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  delete old;
}

}  // namespace rigsound::daemon
