// Output gain of the daemon: mute, the fades around a new engine, the last fade.
#pragma once

namespace rigsound::daemon {

/// A gain that moves evenly to its target. Plain data. Thread: any, one at a time.
class OutputFade {
 public:
  explicit OutputFade(double gain = 1) : from_(gain), to_(gain) {}

  /// To `target` (0...1) within `seconds`, from where the gain is at `now_s`.
  void start(double target, double seconds, double now_s) {
    from_ = gain(now_s);
    to_ = target;
    start_s_ = now_s;
    seconds_ = seconds;
  }
  bool moving(double now_s) const { return now_s < start_s_ + seconds_; }
  double gain(double now_s) const {
    const double share = seconds_ > 0 ? (now_s - start_s_) / seconds_ : 1;
    return share >= 1 ? to_ : from_ + (to_ - from_) * (share > 0 ? share : 0);
  }

 private:
  double from_, to_, start_s_ = 0, seconds_ = 0;
};

}  // namespace rigsound::daemon
