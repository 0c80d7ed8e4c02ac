#include "rigsound/log/change_trace.hpp"

#include <algorithm>
#include <optional>

#include "rigsound/machine/state_resolver.hpp"

namespace rigsound::log {
namespace {

constexpr double kStep = 0.01;  // s

class Watch {
 public:
  Watch(const SafetyOptions& safety, const std::vector<SignalId>& watched,
        const std::function<void(const Change&)>& report)
      : safety_(safety), report_(report) {
    for (const SignalId id : watched) signals_.push_back({id, &board_.entry(id), std::nullopt});
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  SignalBoard& board() { return board_; }

  /// `told`: a reading has come since the last time.
  void compare(double now_s, bool told) {
    const bool due = resolver_.due(now_s);
    if (!told && !due) return;
    if (!due && resolver_.as_told() && only_values_changed()) {
      for (Watched& signal : signals_)
        if (signal.told) tell(signal, signal.known->value, now_s);
      return;
    }
    resolver_.resolve(board_, safety_, now_s);
    for (Watched& signal : signals_) {
      const double value = resolver_.value(signal.id);
      const bool still_absent = !signal.known->ever_good() && !signal.told;
      if (!still_absent || value != info(signal.id.signal).absent) tell(signal, value, now_s);
    }
  }

 private:
  struct Watched {
    SignalId id;
    const SignalBoard::Entry* known;
    std::optional<double> told;
  };

  /// Resolving all signals costs as much as ten frames: while every value known is good, and none is new,
  /// what the buses say is what stands.
  bool only_values_changed() const {
    return std::all_of(signals_.begin(), signals_.end(), [](const Watched& signal) {
      return signal.known->validity == (signal.told ? Validity::kValid : Validity::kNeverSeen);
    });
  }

  void tell(Watched& signal, double value, double now_s) {
    if (signal.told != value) report_({now_s, signal.id, value});
    signal.told = value;
  }

  SafetyOptions safety_;
  SignalBoard board_;
  StateResolver resolver_;
  std::vector<Watched> signals_;
  const std::function<void(const Change&)>& report_;
};

}  // namespace

SignalBoard trace_changes(BusLog& log, const SafetyOptions& safety, const std::vector<SignalId>& watched,
                          const std::function<void(const Change&)>& report) {
  Watch watch(safety, watched, report);
  double now_s = 0;
  while (const auto next_s = log.next_s()) {
    for (now_s += kStep; now_s < *next_s; now_s += kStep) watch.compare(now_s, false);
    now_s = *next_s;
    watch.compare(now_s, log.read_until(now_s, watch.board()));
  }
  return watch.board();
}

}  // namespace rigsound::log
