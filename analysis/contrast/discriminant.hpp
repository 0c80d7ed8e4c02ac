// Two kinds of sounds told apart by a line through their features.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

/// Fisher's linear discriminant; the covariance within the kinds is shrunk as Ledoit and Wolf (2004) have it,
/// so that fewer examples than features will do. Thread: OFF.
class Discriminant {
 public:
  /// Examples as columns, two of each kind at least.
  Discriminant(const Eigen::MatrixXd& first, const Eigen::MatrixXd& second);

  bool is_second(const Eigen::VectorXd& x) const { return direction_.dot(x) > middle_; }

 private:
  Eigen::VectorXd direction_;
  double middle_;
};

/// Both kinds in parts: of each part all others are learned from, then it is judged. Thread: OFF.
struct Judged {
  int right = 0, of = 0;
};
Judged cross_validated(const std::vector<Eigen::MatrixXd>& first, const std::vector<Eigen::MatrixXd>& second);

}  // namespace rigsound::analysis
