#include "clicks/integrated_energy.hpp"

namespace rigsound::analysis {

Eigen::ArrayXd squared_hann(int length) {
  const double step = 2 * static_cast<double>(EIGEN_PI) / (length + 1);
  return (0.5 - 0.5 * (Eigen::ArrayXd::LinSpaced(length, 1, length) * step).cos()).square();
}

Eigen::ArrayXd integrated_energy(const Eigen::ArrayXd& y, const Eigen::ArrayXd& squared_window, long before,
                                 long hop) {
  const long width = squared_window.size(), points = (y.size() + hop - 1) / hop;
  Eigen::ArrayXd padded = Eigen::ArrayXd::Zero(y.size() + 2 * width);
  padded.segment(width, y.size()) = y.square();
  Eigen::ArrayXd e(points);
  for (long i = 0; i < points; ++i)
    e(i) = (padded.segment(width + i * hop - before, width) * squared_window).sum();
  return e;
}

}  // namespace rigsound::analysis
