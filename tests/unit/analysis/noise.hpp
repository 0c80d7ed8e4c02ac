// Repeatable noise for the tests.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <vector>

namespace rigsound::analysis {

constexpr double kPi = 3.141592653589793;

/// Uniform in [0, 1) and standard normal draws that are the same on every machine.
class TestNoise {
 public:
  explicit TestNoise(unsigned seed) : bits_(seed) {}
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }
  Eigen::ArrayXd normals(long count) {
    Eigen::ArrayXd x(count);
    for (double& value : x) value = normal();
    return x;
  }

 private:
  std::mt19937_64 bits_;
};

inline std::vector<float> samples(const Eigen::ArrayXd& x) {
  std::vector<float> out;
  for (const double value : x) out.push_back(static_cast<float>(value));
  return out;
}

}  // namespace rigsound::analysis
