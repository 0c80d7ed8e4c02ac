// The real-time thread: newest state, one block, the sink.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "audio_figures.hpp"
#include "audio_report.hpp"
#include "jump_watch.hpp"
#include "live_states.hpp"
#include "rigsound/audio/block_loop.hpp"
#include "rigsound/audio/sink.hpp"
#include "rigsound/engine.hpp"
#include "rigsound/handoff/swap_slot.hpp"
#include "rigsound/handoff/triple_buffer.hpp"
#include "run_record.hpp"

namespace rigsound::daemon {

/// Renders from construction to stop(). It takes a new engine between two blocks; each begins a
/// new run whose blocks count from 0.
class AudioThread {
 public:
  AudioThread(std::unique_ptr<Engine> engine, audio::Sink& sink, TripleBuffer<StateInput>& states);
  ~AudioThread();
  AudioThread(const AudioThread&) = delete;
  AudioThread& operator=(const AudioThread&) = delete;

  void start();  ///< Thread: CT
  void stop();   ///< Thread: CT

  /// Plays from the next block on. Thread: CT
  void offer_engine(std::unique_ptr<Engine> engine) { next_engine_.offer(std::move(engine)); }
  /// True once it plays; the old one is destroyed. Thread: CT
  bool engine_taken() { return next_engine_.collect() != nullptr; }

  const AudioFigures& figures() const { return figures_; }  ///< Thread: any
  /// The state the engine was last told. Thread: CT, one at a time
  const MachineState& heard() const { return heard_.read(); }
  /// What it sounds like. Thread: CT, one at a time
  const AudioReport& report() const { return report_.read(); }
  /// Whether levels at the ear are taken; not at first. Thread: CT
  void measure_sound(bool on) { measures_sound_.store(on, std::memory_order_relaxed); }
  /// Ends level window `number`, if it is the one under way, at the next block. Thread: CT
  void close_window(std::uint32_t number) { window_to_close_.store(number, std::memory_order_relaxed); }

  RunQueue& records() { return records_; }                       ///< its reader, CT
  const std::string& scheduling() const { return scheduling_; }  ///< "SCHED_FIFO 70", or why not

 private:
  void loop();
  void ask_scheduler();
  void begin_run();
  void render_run();
  void note_jump(std::uint32_t run, std::uint64_t number) noexcept;
  void measure(std::uint64_t spent_ns) noexcept;
  void report_levels(const EngineMeters& meters) noexcept;

  std::unique_ptr<Engine> engine_;
  std::vector<float> block_;  // a new engine's blocks are of the same size
  std::uint64_t deadline_ns_;
  audio::Sink& sink_;
  LiveStates states_;
  mutable TripleBuffer<MachineState> heard_{MachineState{}};
  mutable TripleBuffer<AudioReport> report_{AudioReport{}};
  AudioReport next_report_;  // the audio thread's
  LevelWindow window_;       // the audio thread's: under way
  SoundLevelMeter ear_;      // the audio thread's
  std::atomic<std::uint32_t> window_to_close_{0};
  RunQueue records_{kRunQueueLength};
  AudioFigures figures_;
  RunReporter reporter_{records_, figures_.lost_records};
  JumpWatch jumps_;
  SwapSlot<Engine> next_engine_;
  std::atomic<bool> stop_{false}, ready_{false}, measures_sound_{false};
  std::string scheduling_;
  std::thread thread_;
};

}  // namespace rigsound::daemon
