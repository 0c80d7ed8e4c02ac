// The whole daemon: threads, sound, buses, sessions, control.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audio_thread.hpp"
#include "commands.hpp"
#include "exposure.hpp"
#include "feed.hpp"
#include "levels.hpp"
#include "line_server.hpp"
#include "loaded_rig.hpp"
#include "recorder_thread.hpp"
#include "rig_loader.hpp"
#include "rigsound/audio/null_sink.hpp"
#include "rigsound/audio/sound_card.hpp"
#include "rigsound/osc/osc_bus.hpp"
#include "rigsound/socket/unix_listener.hpp"
#include "service_manager.hpp"
#include "state_exchange.hpp"

namespace rigsound::daemon {

struct SessionOptions {
  std::filesystem::path folder;           ///< of sessions; empty: nothing is recorded
  std::uint64_t limit_bytes = 256 << 20;  ///< of all sessions together
};

struct DaemonOptions {
  std::string rig;
  SessionOptions session;
  config::Buses buses = config::Buses::kRead;  ///< kLeftOut: none is opened, users set the signals
};

/// Thread: main, all of it; construct with the signals of `signals` blocked in every thread.
class Daemon : private DaemonControl, private osc::ControlListener {
 public:
  /// Errors: InputError for the rig and its paths, before anything is opened; DeviceError for the control
  /// socket. A missing card or bus is none.
  explicit Daemon(const DaemonOptions& options);
  ~Daemon() override;

  /// Until SIGTERM or SIGINT, read from `signals` (a signalfd); then the sound fades out and the sockets are
  /// gone. False: a rig was still being read, a card or a disk did not answer; a thread that may use the
  /// daemon waits for it and ends with the process only.
  bool run(int signals);

 private:
  Snapshot snapshot() const override;
  Snapshot scrape() override;
  std::uint64_t ask_reload() override { return reload_queue_.ask(); }
  const ReloadResult* reload_result(std::uint64_t number) const override {
    return reload_queue_.result(number);
  }
  void set_muted(bool muted) override;
  void reset_exposure() override;
  std::vector<std::string> boom_names() const override;
  DrillControls controls(int boom) const override { return exchange_.controls(boom); }
  void set_control(int boom, const ControlInfo& control, double value) override {
    exchange_.set_control(boom, control, value);
  }
  std::vector<std::string> rock_names() const override { return loaded_.sounds.rocks; }
  bool holds(SignalId id) const override { return exchange_.board().entry(id).by_hand; }
  void hold(SignalId id, double value) override;
  void release(SignalId id) override;
  void control(int boom, const ControlInfo& control, double value) override {
    exchange_.set_control(boom, control, value);
  }
  void mute(bool on) override;

  /// A bus of the rig, told as `text`.
  struct FeedPlan {
    std::string text;
    Feed::MakeBus make;
  };

  /// From a rig to be read to one in force.
  struct Change {
    enum class Step : std::uint8_t {
      kNone,
      kReading,
      kFading,    ///< the old engine out
      kSwapping,  ///< engines
      kLeaving,   ///< buses that are no more
    };
    Step step = Step::kNone;
    bool reload = false;  ///< else only a new run of the rig as it is
    std::vector<std::string> not_applied;
    double silent_from_s = 0;  ///< kFading: the gate is shut

    bool moves() const { return step > Step::kReading; }
  };

  void begin_reload();
  void begin_new_run();
  void advance_change(double now_s);
  void take_step(double now_s);
  void take_read_rig(double now_s);
  void swap_when_silent(double now_s);
  std::vector<FeedPlan> feed_plans();
  void leave_feeds();
  void start_feeds();
  void end_change(const std::string& error);

  void open_sockets();
  void poll();
  void poll_session(double now_s);
  void poll_levels();
  void say_turned_down();
  void report_card();
  void report_jumps();
  void handle_signals(int signals);
  bool plays_the_same(const LoadedRig& next) const;  ///< as the running engine
  void fade_out();
  void calibrate();
  session::SessionHeader session_header() const;
  audio::CardStatus card() const;
  std::vector<SignalSnapshot> signal_snapshots(const MachineState& heard) const;
  BoomSnapshot boom_snapshot(int index, const BoomView& view) const;
  Snapshot snapshot_with(const LevelWindow& levels) const;
  std::string rock_name(int rock) const;  ///< empty when the sound set has none of it

  config::Buses buses_;
  LoadedRig loaded_;
  std::optional<session::SessionFolder> sessions_;  // looked at before a card is opened; the recorder's then
  StateExchange exchange_;
  audio::MonotonicClock clock_;
  audio::SoundCard* card_ = nullptr;  // sink_, when there is a card at all
  std::unique_ptr<audio::Sink> sink_;
  AudioThread audio_;
  Levels levels_;
  Exposure exposure_;
  bool turned_down_ = false;  ///< said so
  RecorderThread recorder_;
  std::vector<std::unique_ptr<Feed>> feeds_, leaving_;
  std::optional<UnixListener> control_socket_;
  std::vector<LineServer> servers_;
  RigLoader loader_;
  ReloadQueue reload_queue_;
  Change change_;
  LoadedRig next_;  // while the old engine fades out
  ServiceManager service_;
  audio::CardStatus reported_;
  double start_s_, next_poll_s_ = 0, silent_since_s_ = 0;
  std::uint64_t reloads_ = 0, failed_reloads_ = 0, reported_jumps_ = 0, reported_skipped_ = 0;
  bool stop_ = false;
};

}  // namespace rigsound::daemon
