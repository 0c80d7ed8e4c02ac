// The power of a click train on blocks, and its adjoint, both in time proportional to the signal.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clicks/envelope.hpp"
#include "kernels/click_kernels.hpp"

namespace rigsound::analysis {

/// What the likelihood's gradient is made of: of x_n = min(q_n / v_n, clip) / v_n and of y_n = 1 / v_n.
struct TrainSums {
  Eigen::ArrayXd x, y;  ///< sum_n a^2(n - P_i) x_n and the same of y, of every click
  PairOfSums all;       ///< sum_n x_n, sum_n y_n
};

/// The linear map from the clicks' powers beta_i^2 to v_n = floor + sum_i beta_i^2 a^2(n - P_i) and its
/// transpose. All tails decay alike, so their sum is carried from click to click as one number instead of
/// adding every tail anew: the cost does not depend on how many clicks overlap.
class TrainPower {
 public:
  /// `onset`: P_i in blocks, ascending, may lie before 0; `length`: blocks of the signal.
  TrainPower(const EnvelopePower& shape, const std::vector<long>& onset, long length);

  /// v, `length` values. Thread: OFF.
  void spread(const Eigen::ArrayXd& power, double floor, Eigen::ArrayXd& v) const;

  /// The transpose, of the slopes of a power q under the variance v. Thread: OFF.
  TrainSums weigh(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, double clip) const;

 private:
  struct Click {
    long onset;    ///< P_i
    long start;    ///< where its tail joins the carried one, within the signal
    long end;      ///< where the next one's does
    double first;  ///< tail power per beta^2 at `start`
    double carry;  ///< decay from `start` to `end`
  };
  template <class Visit>
  void each_attack_block(const Click& click, Visit visit) const;

  EnvelopePower shape_;
  std::vector<Click> clicks_;
  Eigen::ArrayXd decay_;  ///< decay^k, as long as the longest stretch without another start
  long length_, before_;  ///< before_: blocks before the first tail
};

}  // namespace rigsound::analysis
