// Several runs of each setting, listened to.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <mutex>
#include <vector>

#include "contrast/listening.hpp"
#include "rigsound/analysis/contrast.hpp"

namespace rigsound::analysis {

struct Run {
  Heard heard;
  double loudness_sone = 0;
  Eigen::MatrixXd excerpts;  ///< what is noticed of each second, a column each
};
using Runs = std::vector<Run>;  ///< of one setting, each with a seed of its own

/// Thread: OFF.
class Listener {
 public:
  Listener(const ContrastOptions& options, const RenderSound& render,
           const std::function<void(int, int)>& progress, int expected_settings);

  /// Runs of each setting. No two runs that this listener ever makes have the same seed.
  std::vector<Runs> listen_to(const std::vector<DrillSetting>& settings);

 private:
  Run run(const DrillSetting& setting, std::uint64_t number) const;

  const ContrastOptions& options_;
  const RenderSound& render_;
  const std::function<void(int, int)>& progress_;
  std::mutex reporting_;
  int total_, done_ = 0;
  std::uint64_t runs_ = 0;
};

}  // namespace rigsound::analysis
