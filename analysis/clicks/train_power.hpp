// The power of a click train on blocks, and its adjoint, both in time proportional to the signal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "clicks/envelope.hpp"

namespace rigsound::analysis {

/// The linear map from the clicks' powers beta_i^2 to v_n = floor + sum_i beta_i^2 a^2(n - P_i) and its
/// transpose. All tails decay alike, so their sum is carried from click to click as one number instead of
/// adding every tail anew: the cost does not depend on how many clicks overlap.
class TrainPower {
 public:
  /// `onset`: P_i in blocks, ascending, may lie before 0; `length`: blocks of the signal.
  TrainPower(const EnvelopePower& shape, const std::vector<long>& onset, long length);

  /// v, `length` values. Thread: OFF.
  void spread(const Eigen::ArrayXd& power, double floor, Eigen::ArrayXd& v) const;

  /// sum_n a^2(n - P_i) x_n and the same of y for every click. Thread: OFF.
  std::array<Eigen::ArrayXd, 2> gather(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) const;

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
  Eigen::ArrayXd decay_;  ///< decay^k
  long length_;
};

}  // namespace rigsound::analysis
