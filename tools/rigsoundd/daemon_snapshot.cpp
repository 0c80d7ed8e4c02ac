#include "daemon.hpp"
#include "log.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {

Snapshot Daemon::snapshot() const {
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
  s.lost_clicks = read(f.lost_clicks);
  s.lost_records = read(f.lost_records);
  s.block_s = loaded_.rig.audio.block / loaded_.rig.audio.rate;
  s.block_mean_s =
      s.blocks > 0 ? static_cast<double>(read(f.busy_ns)) * 1e-9 / static_cast<double>(s.blocks) : 0;
  s.block_worst_s = static_cast<double>(read(f.worst_ns)) * 1e-9;
  s.peak = read(f.peak);
  s.rms = read(f.rms);
  s.limiter_gain = read(f.limiter_gain);
  const MachineState& heard = audio_.heard();
  s.output_gain = static_cast<double>(heard.output_gain);
  s.muted = exchange_.muted();
  s.reloads = reloads_;
  s.failed_reloads = failed_reloads_;
  s.lost_log_entries = lost_log_entries();
  s.session = {recorder_.options().file.string(), recorder_.problem(), recorder_.recording(),
               recorder_.bytes()};
  for (const auto& feed : feeds_) s.buses.push_back(feed->snapshot());
  for (std::size_t b = 0; b < loaded_.rig.engine.booms.size(); ++b)
    s.booms.push_back({loaded_.rig.engine.booms[b].name, exchange_.controls(static_cast<int>(b))});
  s.signals = signal_snapshots(heard);
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
    const double age_s = board.entry(id).ever_good() ? now_s - board.entry(id).seen_s : -1;
    snapshots.push_back({config::signal_label(loaded_.rig, id), std::string(signal.unit),
                         signal.get(heard, id.boom), age_s, std::string(name(validity))});
  });
  return snapshots;
}

}  // namespace rigsound::daemon
