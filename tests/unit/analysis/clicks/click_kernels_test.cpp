#include "kernels/click_kernels.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "analysis/noise.hpp"

using namespace rigsound::analysis;

namespace rigsound::analysis {
extern const ClickKernels kClickKernels_baseline;
}

namespace {

constexpr long kOddLength = 1003;  // no multiple of any lanes

bool same(const PairOfSums& a, const PairOfSums& b) { return a.first == b.first && a.second == b.second; }

}  // namespace

TEST_CASE("every instruction set whitens and weighs with the same bits") {
  TestNoise noise(9);
  const Eigen::ArrayXd q = noise.normals(kOddLength).square(), v = noise.normals(kOddLength).square() + 0.1;
  const ClickKernels &here = click_kernels(), &baseline = kClickKernels_baseline;
  Eigen::ArrayXd a(kOddLength), b(kOddLength), c(kOddLength), d(kOddLength);
  CHECK(same(here.weigh(q.data(), v.data(), 5, kOddLength, a.data(), b.data()),
             baseline.weigh(q.data(), v.data(), 5, kOddLength, c.data(), d.data())));
  CHECK((a == c).all());
  CHECK((b == d).all());
  CHECK(same(here.products(q.data(), a.data(), b.data(), kOddLength),
             baseline.products(q.data(), a.data(), b.data(), kOddLength)));
  CHECK(same(here.divergence(q.data(), v.data(), 5, kOddLength),
             baseline.divergence(q.data(), v.data(), 5, kOddLength)));
  here.tail(1.5, v.data(), 0.25, kOddLength, a.data()),
      baseline.tail(1.5, v.data(), 0.25, kOddLength, c.data());
  CHECK((a == c).all());
}

TEST_CASE("the filter is the sum over its taps, with the same bits from every instruction set") {
  TestNoise noise(10);
  const std::vector<float> x = samples(noise.normals(kOddLength + 6)), A = samples(noise.normals(7));
  std::vector<float> y(kOddLength), other(kOddLength);
  click_kernels().filter(x.data() + 6, kOddLength, A.data(), 7, y.data());
  kClickKernels_baseline.filter(x.data() + 6, kOddLength, A.data(), 7, other.data());
  CHECK(y == other);
  for (const long n : {0L, 500L, kOddLength - 1}) {
    double sum = 0;
    for (int k = 0; k < 7; ++k) sum += double(A[k]) * x[n + 6 - k];
    CHECK(y[n] == doctest::Approx(sum).epsilon(1e-4));
  }
}
