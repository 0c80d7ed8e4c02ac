// The situation of a boom and how far its feed is from normal, at each change of its state.
#pragma once

#include <optional>

#include "rigsound/feed_rule.hpp"

namespace rigsound::session {

/// By the engine's own rule. Thread: one at a time.
class SituationTrace {
 public:
  /// A feed deviation is told again once it has moved by this much.
  static constexpr double kDeviationStep = 0.05;

  explicit SituationTrace(const SceneOptions& scene) : rule_(scene), points_(scene::feed_points(scene)) {}

  /// What has changed; everything at the first call.
  struct Change {
    std::optional<Situation> situation;
    std::optional<double> feed_deviation;  ///< two decimals
  };
  Change update(const BoomState& boom);

 private:
  scene::FeedRule rule_;
  scene::FeedPoints points_;
  std::optional<Situation> situation_;
  std::optional<double> deviation_;
};

}  // namespace rigsound::session
