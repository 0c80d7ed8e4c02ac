#include "daemon.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <csignal>
#include <string_view>
#include <utility>

#include "control_conversation.hpp"
#include "log.hpp"
#include "metrics_page.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/engine_sound.hpp"
#include "rigsound/monotonic_time.hpp"
#include "rigsound/socket/tcp_listener.hpp"
#include "socket_access.hpp"

namespace rigsound::daemon {
namespace {

constexpr double kPoll_s = 0.1, kStep_s = 0.005;
constexpr double kMuteFade_s = 0.1;
constexpr double kRingOut_s =
    0.35;  // longer than the engine takes to follow a shut gate: at the end 1e-6 is silence
constexpr double kControlIdle_s = 3600, kMetricsIdle_s = 10;
constexpr double kExposureFade_s = 0.1;  // as long as a window
constexpr double kSaidFrom_db = 0.5;

std::unique_ptr<audio::Sink> make_sink(const audio::AudioOptions& options, audio::Clock& clock,
                                       audio::SoundCard*& card) {
  if (options.device == "null") return std::make_unique<audio::NullSink>(clock, options.rate, options.block);
  auto sink = audio::make_sound_card(options, clock);
  card = sink.get();
  return sink;
}

std::optional<session::SessionFolder> sessions_of(const SessionOptions& options) {
  if (options.folder.empty()) return std::nullopt;
  return session::SessionFolder(options.folder, options.limit_bytes);
}

void sleep_s(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

}  // namespace

Daemon::Daemon(const DaemonOptions& options)
    : buses_(options.buses),
      loaded_(load(options.rig, buses_)),
      sessions_(sessions_of(options.session)),
      exchange_(loaded_.rig.safety),
      sink_(make_sink(loaded_.rig.audio, clock_, card_)),
      audio_(std::move(loaded_.engine), *sink_, exchange_.handoff()),
      recorder_(std::move(sessions_), audio_.records(), audio_.figures()),
      start_s_(monotonic_s()) {
  calibrate();
  open_sockets();
  start_feeds();
  recorder_.expect_run(session_header());
  audio_.start();
  log_info("audio thread: " + audio_.scheduling());
  if (buses_ == config::Buses::kLeftOut)
    log_info("manual: no bus is opened, signals are set by `rigsound ctl set`");
}

Daemon::~Daemon() {
  feeds_.clear();
  audio_.stop();
}

void Daemon::open_sockets() {
  const config::ControlOptions& control = loaded_.rig.control;
  DaemonControl& self = *this;
  const auto talk = [&self](const std::string& token) {
    return [&self, token] { return std::make_unique<ControlConversation>(self, token); };
  };
  if (!control.socket.empty())
    servers_.emplace_back(control_socket_.emplace(control.socket, access_of(loaded_.rig)).take(),
                          LineServer::Protocol{"\n", kControlIdle_s, talk("")});
  if (!control.tcp.empty())
    servers_.emplace_back(
        listen_tcp(*parse_host_port(control.tcp)),
        LineServer::Protocol{"\n", kControlIdle_s, talk(config::control_token(loaded_.rig))});
  if (!control.metrics.empty())
    servers_.emplace_back(listen_tcp(*parse_host_port(control.metrics)),
                          LineServer::Protocol{"\r\n\r\n", kMetricsIdle_s,
                                               [&self] { return std::make_unique<MetricsPage>(self); }});
}

bool Daemon::run(int signals) {
  service_.ready();
  std::vector<pollfd> polls;
  for (bool busy = false; !stop_;) {
    polls.assign({pollfd{signals, POLLIN, 0}, loader_.to_poll()});
    for (const LineServer& server : servers_) server.add_polls(polls);
    ::poll(polls.data(), polls.size(),
           busy ? 0 : static_cast<int>((change_.moves() ? kStep_s : kPoll_s) * 1e3));
    handle_signals(signals);
    advance_change(monotonic_s());
    busy = false;
    for (LineServer& server : servers_) busy = server.serve() || busy;
    if (monotonic_s() >= next_poll_s_) poll();
  }
  service_.stopping();
  for (const auto& feed : feeds_) feed->stop();
  fade_out();
  audio_.stop();
  const bool recorded = recorder_.finish();
  servers_.clear();
  control_socket_.reset();
  log_info(fmt::format("stopped after {} blocks", audio_.figures().blocks.load()));
  return recorded && !loader_.busy() && (card_ == nullptr || !card_->busy());
}

// The engine smooths every gain: it is silent a little after the gate is shut.
void Daemon::fade_out() {
  exchange_.set_gate(0, kMuteFade_s);
  sleep_s(kMuteFade_s);
  for (double waited_s = 0; waited_s < kRingOut_s && audio_.figures().peak.load() > 0; waited_s += kStep_s)
    sleep_s(kStep_s);
  const audio::AudioOptions& audio = loaded_.rig.audio;
  sleep_s((audio.periods + 1) * audio.block / audio.rate);  // the card plays what it has
}

void Daemon::handle_signals(int signals) {
  signalfd_siginfo info{};
  while (::read(signals, &info, sizeof info) == sizeof info) {
    if (info.ssi_signo == SIGHUP)
      ask_reload();
    else
      stop_ = true;
  }
}

void Daemon::poll() {
  const double now_s = monotonic_s();
  next_poll_s_ = now_s + kPoll_s;
  if (card_ != nullptr) card_->poll();
  report_card();
  report_jumps();
  poll_session(now_s);
  poll_levels();
  for (LineServer& server : servers_) server.tell_news(now_s);
  if (loaded_.osc_output.due(now_s)) loaded_.osc_output.send(snapshot(), now_s);
  service_.watch(audio_.figures().blocks.load(std::memory_order_relaxed), now_s);
}

void Daemon::calibrate() {
  const config::Rig& rig = loaded_.rig;
  exposure_.set(rig.calibration.db_spl_at_0dbfs, rig.safety.max_laeq_db);
  audio_.measure_sound(rig.calibration.db_spl_at_0dbfs > 0);
  exchange_.set_exposure_gain(exposure_.gain(), kExposureFade_s);
}

void Daemon::poll_levels() {
  const LevelWindow& closed = audio_.report().closed;
  if (levels_.take(closed)) {
    const double before = exposure_.gain();
    exposure_.take(closed, loaded_.rig.audio.block / loaded_.rig.audio.rate);
    if (exposure_.gain() != before) exchange_.set_exposure_gain(exposure_.gain(), kExposureFade_s);
    say_turned_down();
  }
  audio_.close_window(levels_.taken() + 1);
}

void Daemon::say_turned_down() {
  const auto exposure = exposure_.snapshot();
  const double down_db = exposure ? exposure->turned_down_db : 0;
  if (turned_down_ ? down_db > 0 : down_db < kSaidFrom_db) return;
  turned_down_ = !turned_down_;
  if (turned_down_)
    log_warning(fmt::format("output turned down: its level at the ear would pass max_laeq_db, {:g} dB(A)",
                            loaded_.rig.safety.max_laeq_db));
  else
    log_info("output no longer turned down");
}

void Daemon::reset_exposure() {
  exposure_.reset();
  log_info("exposure: begins again");
}

void Daemon::poll_session(double now_s) {
  if (audio_.figures().peak.load(std::memory_order_relaxed) > 0) silent_since_s_ = now_s;
  recorder_.set_silent_s(now_s - silent_since_s_);
  if (change_.step != Change::Step::kNone) return;
  const RecorderStatus recorder = recorder_.status();
  if (recorder.run != audio_.figures().run.load(std::memory_order_relaxed)) return;  // of a run that is over
  const bool other_card = recorder.recording && recorder.format != session_header().format;
  const std::string_view why = other_card ? "was begun for another sample format" : recorder.wants_new_run;
  if (why.empty()) return;
  log_info(fmt::format("session: {} {}, the next one begins", recorder.file.string(), why));
  begin_new_run();
}

void Daemon::set_muted(bool muted) {
  exchange_.set_muted(muted, kMuteFade_s);
  log_info(muted ? "muted" : "unmuted");
}

/// Called by the thread of OSC.
void Daemon::mute(bool on) {
  if (on != exchange_.muted()) set_muted(on);
}

void Daemon::hold(SignalId id, double value) {
  exchange_.change([&](SignalBoard& board) { board.hold(id, value); });
  log_info(fmt::format("{}: {:g} by hand", config::signal_label(loaded_.rig, id), value));
}

void Daemon::release(SignalId id) {
  exchange_.change([&](SignalBoard& board) { board.release(id); });
  log_info(config::signal_label(loaded_.rig, id) + ": released");
}

std::vector<std::string> Daemon::boom_names() const {
  std::vector<std::string> names;
  for (const BoomOptions& boom : loaded_.rig.engine.booms) names.push_back(boom.name);
  return names;
}

audio::CardStatus Daemon::card() const {
  if (card_ != nullptr) return card_->status();
  audio::CardStatus none;
  none.description = "the rig's device is \"null\"";
  return none;
}

void Daemon::report_card() {
  constexpr const char* kWords[audio::kCardEventCount] = {
      "xruns", "suspends", "bad states", "short writes", "interruptions", "losses of the card"};
  const audio::CardStatus now = card();
  for (std::size_t i = 0; i < now.events.size(); ++i)
    if (now.events[i] != reported_.events[i])
      log_warning(fmt::format("sound card: {} {}, {} in all", now.events[i] - reported_.events[i], kWords[i],
                              now.events[i]));
  if (now.description != reported_.description || now.playing != reported_.playing)
    now.playing ? log_info(now.description) : log_warning("no sound: " + now.description);
  reported_ = now;
  std::string status = now.playing ? now.description : "no sound: " + now.description;
  for (const auto& feed : feeds_) {
    const BusSnapshot bus = feed->snapshot();
    status += "; " + bus.name + (bus.up ? " up" : " down");
  }
  service_.status(status);
}

void Daemon::report_jumps() {
  const std::uint64_t jumps = audio_.figures().clock_jumps.load(std::memory_order_relaxed);
  const std::uint64_t skipped = audio_.figures().skipped_blocks.load(std::memory_order_relaxed);
  if (jumps == reported_jumps_) return;
  const audio::AudioOptions& audio = loaded_.rig.audio;
  log_warning(fmt::format("no block was rendered for {:.1f} s: the machine stood still",
                          static_cast<double>(skipped - reported_skipped_) * audio.block / audio.rate));
  reported_jumps_ = jumps;
  reported_skipped_ = skipped;
}

session::SessionHeader Daemon::session_header() const {
  session::SessionHeader header;
  header.program = RIGSOUND_VERSION;
  header.fingerprint = loaded_.fingerprint;
  header.engine = kEngineSound;
  header.seed = loaded_.rig.engine.seed;
  header.sample_rate = loaded_.rig.engine.sample_rate;
  header.block = loaded_.rig.engine.block;
  header.channels = loaded_.rig.engine.channels;
  const audio::SampleFormat granted = card().format;
  header.format = granted != audio::SampleFormat::kAuto ? granted : loaded_.rig.audio.format;
  return header;
}

}  // namespace rigsound::daemon
