// The whole daemon: threads, sound, buses, sessions, control.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "audio_thread.hpp"
#include "commands.hpp"
#include "exposure.hpp"
#include "feed.hpp"
#include "levels.hpp"
#include "line_server.hpp"
#include "loaded_rig.hpp"
#include "osc_output.hpp"
#include "recorder.hpp"
#include "rigsound/audio/null_sink.hpp"
#include "rigsound/audio/sound_card.hpp"
#include "rigsound/osc/osc_bus.hpp"
#include "service_manager.hpp"
#include "state_exchange.hpp"

namespace rigsound::daemon {

struct DaemonOptions {
  std::string rig;
  RecorderOptions session;
  config::Buses buses = config::Buses::kRead;  ///< kLeftOut: none is opened, users set the signals
};

/// Thread: main, all of it; construct with the signals of `signals` blocked in every thread.
class Daemon : private DaemonControl, private osc::ControlListener {
 public:
  /// Errors: InputError for the rig, DeviceError for the control socket. A missing card or bus is none.
  explicit Daemon(const DaemonOptions& options);
  ~Daemon() override;

  /// Until SIGTERM or SIGINT, read from `signals` (a signalfd); then the sound fades out.
  void run(int signals);

 private:
  Snapshot snapshot() const override;
  Snapshot scrape() override;
  ReloadResult reload() override;
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

  void open_sockets();
  /// Feeds for the buses of loaded_; those of `kept` that are told the same go on as they are.
  void start_feeds(std::vector<std::unique_ptr<Feed>> kept);
  void poll();
  void poll_session(double now_s);
  void poll_levels();
  void say_turned_down();
  void report_card();
  void handle_signals(int signals);
  bool plays_the_same(const LoadedRig& next) const;  ///< as the running engine
  void take_settings(LoadedRig next);
  void calibrate();
  void new_run(LoadedRig next);
  void fade_to_silence(double fade_s);
  session::SessionHeader session_header() const;
  audio::CardStatus card() const;
  std::vector<SignalSnapshot> signal_snapshots(const MachineState& heard) const;
  BoomSnapshot boom_snapshot(int index, const BoomView& view) const;
  Snapshot snapshot_with(const LevelWindow& levels) const;
  std::string rock_name(int rock) const;  ///< empty when the sound set has none of it

  config::Buses buses_;
  LoadedRig loaded_;
  StateExchange exchange_;
  audio::MonotonicClock clock_;
  audio::SoundCard* card_ = nullptr;  // sink_, when there is a card at all
  std::unique_ptr<audio::Sink> sink_;
  AudioThread audio_;
  Levels levels_;
  Exposure exposure_;
  bool turned_down_ = false;  ///< said so
  Recorder recorder_;
  std::vector<std::unique_ptr<Feed>> feeds_;
  std::vector<LineServer> servers_;
  std::optional<OscOutput> osc_output_;
  ServiceManager service_;
  audio::CardStatus reported_;
  double start_s_, next_poll_s_ = 0, silent_since_s_ = 0;
  std::uint64_t reloads_ = 0, failed_reloads_ = 0;
  bool stop_ = false;
};

}  // namespace rigsound::daemon
