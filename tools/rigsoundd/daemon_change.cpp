// From a rig that is read to one in force, step by step: the main thread waits for none of them.
#include <algorithm>
#include <exception>
#include <map>
#include <utility>

#include "daemon.hpp"
#include "log.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/config/bus_text.hpp"
#include "rigsound/modbus/modbus_bus.hpp"
#include "rigsound/monotonic_time.hpp"
#include "rigsound/udp/udp_bus.hpp"

namespace rigsound::daemon {
namespace {

constexpr double kSwapFade_s = 0.03;  // around a new engine
constexpr double kLongestRingOut_s = 1;

}  // namespace

void Daemon::begin_reload() {
  reload_queue_.begin();
  service_.reloading();
  change_ = {Change::Step::kReading, true, {}, {}};
  loader_.begin([rig = loaded_.rig, buses = buses_](std::vector<std::string>& not_applied) {
    return load_for_reload(rig, buses, not_applied);
  });
}

void Daemon::begin_new_run() {
  change_ = {Change::Step::kReading, false, {}, {}};
  loader_.begin([rig = loaded_.rig](std::vector<std::string>&) { return build(rig); });
}

void Daemon::advance_change(double now_s) {
  try {
    take_step(now_s);
  } catch (const std::exception& error) {
    end_change(error.what());
  }
}

void Daemon::take_step(double now_s) {
  if (change_.step == Change::Step::kNone && reload_queue_.due()) begin_reload();
  if (change_.step == Change::Step::kReading) take_read_rig(now_s);
  if (change_.step == Change::Step::kFading) swap_when_silent(now_s);
  if (change_.step == Change::Step::kSwapping && audio_.engine_taken()) {
    exchange_.set_gate(1, kSwapFade_s);
    change_.reload ? leave_feeds() : end_change({});
  }
  if (change_.step == Change::Step::kLeaving) start_feeds();
}

bool Daemon::plays_the_same(const LoadedRig& next) const {
  return next.fingerprint == loaded_.fingerprint && next.rig.engine.seed == loaded_.rig.engine.seed;
}

void Daemon::take_read_rig(double now_s) {
  std::optional<RigLoader::Outcome> read = loader_.take();
  if (!read) return;
  if (!read->error.empty()) return end_change(read->error);
  change_.not_applied = std::move(read->not_applied);
  exchange_.set_safety(read->rig.rig.safety);
  if (change_.reload && plays_the_same(read->rig) && recorder_.status().problem.empty()) {
    read->rig.engine.reset();  // the running one goes on
    loaded_ = std::move(read->rig);
    calibrate();
    return leave_feeds();
  }
  next_ = std::move(read->rig);
  exchange_.set_gate(0, kSwapFade_s);
  change_.step = Change::Step::kFading;
  change_.silent_from_s = now_s + kSwapFade_s;
}

/// The old engine's end must not be heard, nor the new one's start: both are silent where they meet. The
/// engine smooths every gain: it is silent a little after the gate is shut.
void Daemon::swap_when_silent(double now_s) {
  const bool rings = audio_.figures().peak.load(std::memory_order_relaxed) > 0;
  if (now_s < change_.silent_from_s + (rings ? kLongestRingOut_s : 0)) return;
  std::unique_ptr<Engine> engine = std::move(next_.engine);
  loaded_ = std::exchange(next_, {});
  calibrate();
  recorder_.expect_run(session_header());
  audio_.offer_engine(std::move(engine));
  change_.step = Change::Step::kSwapping;
}

std::vector<Daemon::FeedPlan> Daemon::feed_plans() {
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
  return plans;
}

/// Those of buses that are told the same go on as they are; the others end before new ones take their ports.
void Daemon::leave_feeds() {
  const std::vector<FeedPlan> plans = feed_plans();
  const auto stays = [&](const std::unique_ptr<Feed>& feed) {
    return std::any_of(plans.begin(), plans.end(),
                       [&](const FeedPlan& p) { return p.text == feed->bus_text(); });
  };
  const auto first_leaving = std::stable_partition(feeds_.begin(), feeds_.end(), stays);
  std::move(first_leaving, feeds_.end(), std::back_inserter(leaving_));
  feeds_.erase(first_leaving, feeds_.end());
  for (const std::unique_ptr<Feed>& feed : leaving_) feed->stop();
  change_.step = Change::Step::kLeaving;
}

void Daemon::start_feeds() {
  if (!std::all_of(leaving_.begin(), leaving_.end(), [](const auto& feed) { return feed->ended(); })) return;
  leaving_.clear();
  std::map<std::string, std::unique_ptr<Feed>> same;
  for (std::unique_ptr<Feed>& feed : feeds_) same[feed->bus_text()] = std::move(feed);
  feeds_.clear();
  for (FeedPlan& p : feed_plans()) {
    std::unique_ptr<Feed>& old = same[p.text];
    feeds_.push_back(old != nullptr ? std::move(old)
                                    : std::make_unique<Feed>(p.make, exchange_, std::move(p.text)));
  }
  end_change({});
}

void Daemon::end_change(const std::string& error) {
  const Change change = std::exchange(change_, {});
  if (!change.reload) {
    if (!error.empty()) recorder_.give_up("no new session, the sound set can no longer be played: " + error);
    return;
  }
  if (error.empty()) {
    ++reloads_;
    log_info("reloaded " + loaded_.rig.file.string());
    for (const std::string& key : change.not_applied) log_warning("reload: needs a restart: " + key);
  } else {
    ++failed_reloads_;
    log_error("reload refused, the old rig goes on: " + error);
  }
  service_.ready();
  reload_queue_.finish({error, change.not_applied});
}

}  // namespace rigsound::daemon
