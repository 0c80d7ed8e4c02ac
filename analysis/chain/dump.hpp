// Intermediate signals on disk, for the inspection of a step.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// Writes into one folder, or nowhere when it has none. Errors: DeviceError. Thread: OFF.
class Dump {
 public:
  explicit Dump(std::filesystem::path folder);

  /// False when nothing is written: for what only a dump computes.
  explicit operator bool() const { return !folder_.empty(); }

  /// NAME.wav at kAnalysisRate.
  void signal(const std::string& name, const Eigen::ArrayXd& samples) const;

  /// NAME.csv: `header`, then one row for each row of `table`.
  void table(const std::string& name, const std::string& header, const Eigen::ArrayXXd& table) const;

  /// NAME_clicks.csv and NAME_envelope.csv.
  void train(const std::string& name, const ClickTrain& train) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace rigsound::analysis
