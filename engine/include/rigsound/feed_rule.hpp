// From feed pressure and rattling mode to the drilling situation, with hysteresis; where situations stand.
#pragma once

#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/situation.hpp"
#include "rigsound/options.hpp"

namespace rigsound::scene {

/// Feed pressures at which the three drilling situations stand, bar.
struct FeedPoints {
  double underfeed, normal, overfeed;

  /// -1 at underfeed, 0 at normal, +1 at overfeed, and on beyond.
  double deviation(double feed_bar) const noexcept;
};
FeedPoints feed_points(const SceneOptions& options) noexcept;

/// Remembers on which side of each threshold the pressure last was. Thread: RT.
class FeedRule {
 public:
  explicit FeedRule(const SceneOptions& options) noexcept : options_(options) {}

  void update(const BoomState& boom) noexcept;

  Situation situation() const noexcept { return situation_; }
  bool hammering() const noexcept { return hammering_; }

 private:
  SceneOptions options_;
  bool in_contact_ = false, under_ = true, over_ = false, hammering_ = false;
  Situation situation_ = Situation::kUnderfeed;
};

}  // namespace rigsound::scene
