#include "numeric/levinson.hpp"

namespace rigsound::analysis {

Eigen::ArrayXd levinson(const Eigen::ArrayXd& r) {
  const long order = r.size() - 1;
  Eigen::ArrayXd a = Eigen::ArrayXd::Zero(order + 1);
  a(0) = 1;
  double error = r(0);
  for (long p = 1; p <= order; ++p) {
    const double reflection = -(a.head(p) * r.segment(1, p).reverse()).sum() / error;
    a.segment(1, p) += reflection * a.head(p).reverse().eval();
    error *= 1 - reflection * reflection;
  }
  return a;
}

}  // namespace rigsound::analysis
