#include "rigsound/log/change_trace.hpp"

#include <optional>

#include "rigsound/machine/state_resolver.hpp"

namespace rigsound::log {
namespace {

constexpr double kStep = 0.01;  // s

class Watch {
 public:
  Watch(const SafetyOptions& safety, const std::vector<SignalId>& watched,
        const std::function<void(const Change&)>& report)
      : safety_(safety), watched_(watched), told_(watched.size()), report_(report) {}

  SignalBoard& board() { return board_; }

  void compare(double now_s) {
    resolver_.resolve(board_, safety_, now_s);
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      const double value = resolver_.value(watched_[i]);
      const bool still_absent = !board_.entry(watched_[i]).ever_good() && !told_[i];
      if (still_absent && value == info(watched_[i].signal).absent) continue;
      if (told_[i] != value) report_({now_s, watched_[i], value});
      told_[i] = value;
    }
  }

 private:
  SafetyOptions safety_;
  SignalBoard board_;
  StateResolver resolver_;
  const std::vector<SignalId>& watched_;
  std::vector<std::optional<double>> told_;
  const std::function<void(const Change&)>& report_;
};

}  // namespace

SignalBoard trace_changes(BusLog& log, const SafetyOptions& safety, const std::vector<SignalId>& watched,
                          const std::function<void(const Change&)>& report) {
  Watch watch(safety, watched, report);
  double now_s = 0;
  while (const auto next_s = log.next_s()) {
    for (now_s += kStep; now_s < *next_s; now_s += kStep) watch.compare(now_s);
    now_s = *next_s;
    log.read_until(now_s, watch.board());
    watch.compare(now_s);
  }
  return watch.board();
}

}  // namespace rigsound::log
