#include "daemon.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <map>
#include <utility>

#include "control_conversation.hpp"
#include "control_socket.hpp"
#include "log.hpp"
#include "metrics_page.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/config/bus_text.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/modbus/modbus_bus.hpp"
#include "rigsound/monotonic_time.hpp"
#include "rigsound/socket/tcp_listener.hpp"
#include "rigsound/udp/udp_bus.hpp"

namespace rigsound::daemon {
namespace {

constexpr double kPoll_s = 0.1;
constexpr double kSwapFade_s = 0.03;  // around a new engine
constexpr double kMuteFade_s = 0.1, kLastFade_s = 0.3;
constexpr double kLongestRingOut_s = 1;
constexpr double kExposureFade_s = 0.1;  // as long as a window
constexpr double kSaidFrom_db = 0.5;

std::unique_ptr<audio::Sink> make_sink(const audio::AudioOptions& options, audio::Clock& clock,
                                       audio::SoundCard*& card) {
  if (options.device == "null") return std::make_unique<audio::NullSink>(clock, options.rate, options.block);
  auto sink = audio::make_sound_card(options, clock);
  card = sink.get();
  return sink;
}

void sleep_s(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// A bus of the rig, told as `text`.
struct FeedPlan {
  std::string text;
  Feed::MakeBus make;
};

}  // namespace

Daemon::Daemon(const DaemonOptions& options)
    : buses_(options.buses),
      loaded_(load(options.rig, buses_)),
      exchange_(loaded_.rig.safety),
      sink_(make_sink(loaded_.rig.audio, clock_, card_)),
      audio_(std::move(loaded_.engine), *sink_, exchange_.handoff()),
      recorder_(options.session, audio_.records(), audio_.figures()),
      start_s_(monotonic_s()) {
  calibrate();
  open_sockets();
  start_feeds({});
  recorder_.expect_run(session_header());
  audio_.start();
  log_info("audio thread: " + audio_.scheduling());
  if (buses_ == config::Buses::kLeftOut)
    log_info("manual: no bus is opened, signals are set by `rigsound ctl set`");
}

Daemon::~Daemon() {
  feeds_.clear();
  audio_.stop();
  remove_socket(loaded_.rig.control.socket);
}

void Daemon::open_sockets() {
  const config::ControlOptions& control = loaded_.rig.control;
  DaemonControl& self = *this;
  const auto talk = [&self](const std::string& token) {
    return [&self, token] { return std::make_unique<ControlConversation>(self, token); };
  };
  if (!control.socket.empty())
    servers_.emplace_back(listen_unix(control.socket, access_of(loaded_.rig)),
                          LineServer::Protocol{"\n", talk("")});
  if (!control.tcp.empty())
    servers_.emplace_back(listen_tcp(*parse_host_port(control.tcp)),
                          LineServer::Protocol{"\n", talk(config::control_token(loaded_.rig))});
  if (!control.metrics.empty())
    servers_.emplace_back(
        listen_tcp(*parse_host_port(control.metrics)),
        LineServer::Protocol{"\r\n\r\n", [&self] { return std::make_unique<MetricsPage>(self); }});
}

void Daemon::start_feeds(std::vector<std::unique_ptr<Feed>> kept) {
  std::vector<FeedPlan> plans;
  const auto plan = [&](const auto& bus) {
    plans.push_back(
        {config::bus_text(bus), [bus](BusListener& listener) { return make_bus(bus, listener); }});
  };
  for (const can::CanOptions& bus : loaded_.rig.can) plan(bus);
  for (const modbus::Line& line : modbus::lines(loaded_.rig.modbus)) plan(line);
  for (const udp::UdpOptions& input : loaded_.rig.udp) plan(input);
  if (const osc::OscOptions& osc = loaded_.rig.osc; !osc.address.empty())
    plans.push_back({config::bus_text(osc),
                     [this, osc](BusListener& listener) { return osc::make_bus(osc, listener, *this); }});

  std::map<std::string, std::unique_ptr<Feed>> same;
  for (std::unique_ptr<Feed>& feed : kept)
    if (std::any_of(plans.begin(), plans.end(),
                    [&](const FeedPlan& p) { return p.text == feed->bus_text(); }))
      same[feed->bus_text()] = std::move(feed);
  kept.clear();  // before others take their ports
  for (FeedPlan& p : plans) {
    std::unique_ptr<Feed>& old = same[p.text];
    feeds_.push_back(old != nullptr ? std::move(old)
                                    : std::make_unique<Feed>(p.make, exchange_, std::move(p.text)));
  }
  osc_output_.emplace(loaded_.rig.osc);
}

void Daemon::run(int signals) {
  service_.ready();
  std::vector<pollfd> polls;
  for (bool busy = false; !stop_;) {
    polls.assign(1, pollfd{signals, POLLIN, 0});
    for (const LineServer& server : servers_) server.add_polls(polls);
    ::poll(polls.data(), polls.size(), busy ? 0 : static_cast<int>(kPoll_s * 1e3));
    handle_signals(signals);
    busy = false;
    for (LineServer& server : servers_) busy = server.serve() || busy;
    if (monotonic_s() >= next_poll_s_) poll();
  }
  service_.stopping();
  fade_to_silence(kLastFade_s);
  const audio::AudioOptions& audio = loaded_.rig.audio;
  sleep_s((audio.periods + 1) * audio.block / audio.rate);  // the card plays what it has
  audio_.stop();
  recorder_.finish();
  log_info(fmt::format("stopped after {} blocks", audio_.figures().blocks.load()));
}

// The engine smooths every gain: it is silent a little after the gate is shut.
void Daemon::fade_to_silence(double fade_s) {
  exchange_.set_gate(0, fade_s);
  sleep_s(fade_s);
  for (double waited_s = 0; waited_s < kLongestRingOut_s && audio_.figures().peak.load() > 0;
       waited_s += 0.005)
    sleep_s(0.005);
}

void Daemon::handle_signals(int signals) {
  signalfd_siginfo info{};
  while (::read(signals, &info, sizeof info) == sizeof info) {
    if (info.ssi_signo == SIGHUP)
      reload();
    else
      stop_ = true;
  }
}

void Daemon::poll() {
  const double now_s = monotonic_s();
  next_poll_s_ = now_s + kPoll_s;
  if (card_ != nullptr) card_->poll();
  report_card();
  poll_session(now_s);
  poll_levels();
  for (LineServer& server : servers_) server.tell_news(now_s);
  if (osc_output_->due(now_s)) osc_output_->send(snapshot(), now_s);
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
  recorder_.poll(now_s);
  if (audio_.figures().peak.load(std::memory_order_relaxed) > 0) silent_since_s_ = now_s;
  const bool other_card = recorder_.recording() && recorder_.header().format != session_header().format;
  if (!other_card && !recorder_.wants_new_run(now_s - silent_since_s_)) return;
  log_info(fmt::format("session: {} {}, the next one begins", recorder_.file().string(),
                       other_card ? "was begun for another sample format" : "is full"));
  try {
    new_run(build(loaded_.rig));
  } catch (const std::exception& error) {
    recorder_.give_up(std::string("no new session, the sound set can no longer be played: ") + error.what());
  }
}

bool Daemon::plays_the_same(const LoadedRig& next) const {
  return next.fingerprint == loaded_.fingerprint && next.rig.engine.seed == loaded_.rig.engine.seed;
}

/// The old engine's end must not be heard, nor the new one's start: both are silent where they meet.
void Daemon::new_run(LoadedRig next) {
  fade_to_silence(kSwapFade_s);
  recorder_.poll(monotonic_s());
  std::unique_ptr<Engine> engine = std::move(next.engine);
  loaded_ = std::move(next);
  recorder_.expect_run(session_header());
  audio_.replace_engine(std::move(engine));
  exchange_.set_gate(1, kSwapFade_s);
}

/// All of the rig but its engine: the running one plays the same and goes on.
void Daemon::take_settings(LoadedRig next) {
  next.engine.reset();
  loaded_ = std::move(next);
}

ReloadResult Daemon::reload() {
  ReloadResult result;
  service_.reloading();
  try {
    LoadedRig next = load_for_reload(loaded_.rig, buses_, result.not_applied);
    exchange_.set_safety(next.rig.safety);
    if (plays_the_same(next) && recorder_.problem().empty())
      take_settings(std::move(next));
    else
      new_run(std::move(next));
    calibrate();
    start_feeds(std::exchange(feeds_, {}));
    ++reloads_;
    log_info("reloaded " + loaded_.rig.file.string());
    for (const std::string& key : result.not_applied) log_warning("reload: needs a restart: " + key);
  } catch (const std::exception& error) {
    ++failed_reloads_;
    result.error = error.what();
    result.not_applied.clear();
    log_error(std::string("reload refused, the old rig goes on: ") + error.what());
  }
  service_.ready();
  return result;
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

session::SessionHeader Daemon::session_header() const {
  session::SessionHeader header;
  header.program = RIGSOUND_VERSION;
  header.fingerprint = loaded_.fingerprint;
  header.seed = loaded_.rig.engine.seed;
  header.sample_rate = loaded_.rig.engine.sample_rate;
  header.block = loaded_.rig.engine.block;
  header.channels = loaded_.rig.engine.channels;
  const audio::SampleFormat granted = card().format;
  header.format = granted != audio::SampleFormat::kAuto ? granted : loaded_.rig.audio.format;
  return header;
}

}  // namespace rigsound::daemon
