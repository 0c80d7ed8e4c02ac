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

bool same(const WeighedSums& a, const WeighedSums& b) {
  return a.x == b.x && a.y == b.y && a.ax == b.ax && a.ay == b.ay;
}

}  // namespace

TEST_CASE("every instruction set whitens and weighs with the same bits") {
  TestNoise noise(9);
  const Eigen::ArrayXd q = noise.normals(kOddLength).square(), v = noise.normals(kOddLength).square() + 0.1;
  const ClickKernels &here = click_kernels(), &baseline = kClickKernels_baseline;
  const Eigen::ArrayXd decay = Eigen::ArrayXd::LinSpaced(kOddLength, 1, 0);
  Eigen::ArrayXd a(kOddLength), c(kOddLength);
  for (const long length : {0L, 5L, 13L, 16L, kOddLength})
    CHECK(same(here.weigh(q.data(), v.data(), decay.data(), 5, length),
               baseline.weigh(q.data(), v.data(), decay.data(), 5, length)));
  CHECK(same(here.products(q.data(), v.data(), decay.data(), kOddLength),
             baseline.products(q.data(), v.data(), decay.data(), kOddLength)));
  CHECK(same(here.divergence(q.data(), v.data(), 5, kOddLength),
             baseline.divergence(q.data(), v.data(), 5, kOddLength)));
  here.tail(1.5, v.data(), 0.25, kOddLength, a.data()),
      baseline.tail(1.5, v.data(), 0.25, kOddLength, c.data());
  CHECK((a == c).all());
}

TEST_CASE("weighing sums what the multiplicative update needs, at any length") {
  TestNoise noise(11);
  const Eigen::ArrayXd q = 9 * noise.normals(45).square(), v = noise.normals(45).square() + 0.1,
                       a = noise.normals(45).square();
  for (const long length : {0L, 1L, 7L, 8L, 9L, 15L, 16L, 17L, 45L}) {
    const Eigen::ArrayXd y = 1 / v.head(length), x = (q.head(length) * y).min(5) * y;
    const WeighedSums sums = click_kernels().weigh(q.data(), v.data(), a.data(), 5, length);
    CHECK(sums.x == doctest::Approx(x.sum()));
    CHECK(sums.y == doctest::Approx(y.sum()));
    CHECK(sums.ax == doctest::Approx((a.head(length) * x).sum()));
    CHECK(sums.ay == doctest::Approx((a.head(length) * y).sum()));
  }
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
