#include <algorithm>

#include "daemon.hpp"
#include "log.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {
namespace {

/// A server and a client at one address have one name; figures go by names.
void name_apart(std::vector<BusSnapshot>& buses) {
  for (std::size_t i = 0; i < buses.size(); ++i) {
    int same = 1;
    for (std::size_t j = i + 1; j < buses.size(); ++j)
      if (buses[j].name == buses[i].name) buses[j].name += " #" + std::to_string(++same);
  }
}

LevelSnapshot level(const LevelSum& sum, std::uint64_t blocks) {
  return {static_cast<double>(sum.peak), sum.rms(blocks)};
}

}  // namespace

Snapshot Daemon::snapshot() const { return snapshot_with(levels_.recent()); }
Snapshot Daemon::scrape() { return snapshot_with(levels_.since_scrape()); }

Snapshot Daemon::snapshot_with(const LevelWindow& levels) const {
  Snapshot s;
  const AudioFigures& f = audio_.figures();
  const auto read = [](const auto& x) { return x.load(std::memory_order_relaxed); };
  s.version = RIGSOUND_VERSION;
  s.rig = loaded_.rig.file.string();
  s.uptime_s = monotonic_s() - start_s_;
  s.card = card();
  s.scheduling = audio_.scheduling();
  s.blocks = read(f.blocks);
  s.deadline_misses = read(f.deadline_misses);
  s.clock_jumps = read(f.clock_jumps);
  s.skipped_blocks = read(f.skipped_blocks);
  s.lost_clicks = read(f.lost_clicks);
  s.dropped_chunks = read(f.dropped_chunks);
  s.lost_records = read(f.lost_records);
  s.block_s = loaded_.rig.audio.block / loaded_.rig.audio.rate;
  const auto busy_s = static_cast<double>(f.busy_ns.load(std::memory_order_acquire)) * 1e-9;
  const std::uint64_t measured = read(f.measured);
  s.block_mean_s = measured > 0 ? busy_s / static_cast<double>(measured) : 0;
  s.block_worst_s = static_cast<double>(read(f.worst_ns)) * 1e-9;
  s.output = level(levels.output, levels.blocks);
  s.diesel = level(levels.diesel, levels.blocks);
  s.limiter_gain = static_cast<double>(levels.limiter_gain);
  s.exposure = exposure_.snapshot();
  const MachineState& heard = audio_.heard();
  s.output_gain = static_cast<double>(heard.output_gain);
  s.muted = exchange_.muted();
  s.no_buses = buses_ == config::Buses::kLeftOut;
  s.reloads = reloads_;
  s.failed_reloads = failed_reloads_;
  s.lost_log_entries = lost_log_entries();
  const RecorderStatus recorder = recorder_.status();
  s.session = {recorder.file.string(), recorder.problem, recorder.recording, recorder.bytes};
  for (const auto& feed : feeds_) s.buses.push_back(feed->snapshot());
  name_apart(s.buses);
  const EngineView& view = audio_.report().view;
  s.paused = view.stands_still;
  for (int b = 0; b < static_cast<int>(loaded_.rig.engine.booms.size()); ++b) {
    s.booms.push_back(boom_snapshot(b, view.boom[b]));
    s.booms.back().drill_level = level(levels.drill[b], levels.blocks);
    s.booms.back().tool_level = level(levels.tool[b], levels.blocks);
  }
  s.signals = signal_snapshots(heard);
  return s;
}

std::string Daemon::rock_name(int rock) const {
  const std::vector<std::string>& rocks = loaded_.sounds.rocks;
  return rock >= 0 && rock < static_cast<int>(rocks.size()) ? rocks[rock] : "";
}

BoomSnapshot Daemon::boom_snapshot(int index, const BoomView& view) const {
  const BoomOptions& boom = loaded_.rig.engine.booms[index];
  BoomSnapshot s;
  s.name = boom.name;
  s.controls = exchange_.controls(index);
  s.situation = view.situation;
  s.hammering = view.hammering;
  s.feed_deviation = static_cast<double>(view.feed_deviation);
  for (int i = 0; i < view.bank_count; ++i) {
    const BankShare& bank = view.banks[i];
    if (bank.bank <
        static_cast<int>(loaded_.sounds.banks.size()))  // not so in the last block before a reload
      s.banks.push_back({loaded_.sounds.banks[bank.bank], static_cast<double>(bank.share), bank.rods,
                         rock_name(bank.rock)});
  }
  std::stable_sort(s.banks.begin(), s.banks.end(),
                   [](const BankSnapshot& a, const BankSnapshot& b) { return a.share > b.share; });
  s.rods = view.rods;
  s.rock = rock_name(view.rock);
  if (s.rock.empty()) s.rock = std::to_string(view.rock);
  s.impacts_wanted_hz = static_cast<double>(view.impact_rate_hz);
  s.impacts_made_hz = static_cast<double>(view.impacts_made_hz);
  s.tool = boom.tool >= 0 ? "tool" : boom.drill_string >= 0 ? "string" : "";
  return s;
}

std::vector<SignalSnapshot> Daemon::signal_snapshots(const MachineState& heard) const {
  std::vector<SignalSnapshot> snapshots;
  const double now_s = monotonic_s();
  const SignalBoard board = exchange_.board();
  const SafetyOptions safety = exchange_.safety();
  for_each_signal(static_cast<int>(loaded_.rig.engine.booms.size()), [&](SignalId id) {
    const SignalInfo& signal = info(id.signal);
    const Validity validity = board.validity(id, safety.rule[static_cast<std::size_t>(id.signal)], now_s);
    const SignalBoard::Entry& entry = board.entry(id);
    const double age_s = entry.ever_good() ? now_s - entry.seen_s : -1;
    SignalSnapshot s;
    s.name = config::signal_label(loaded_.rig, id);
    s.unit = signal.unit;
    s.value = signal.get(heard, id.boom);
    s.age_s = age_s;
    s.validity = name(validity);
    s.word = id.signal == Signal::kRock ? rock_name(static_cast<int>(s.value))
                                        : std::string(value_word(id.signal, s.value));
    s.refused = entry.refused;
    s.clamped = entry.clamped;
    if (entry.last_refusal == Validity::kOutOfRange) s.last_refused = entry.last_refused;
    snapshots.push_back(std::move(s));
  });
  return snapshots;
}

}  // namespace rigsound::daemon
