#include "rigsound/dsp/energy.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace rigsound;

TEST_CASE("energy is the sum of the squares of all samples, however many there are") {
  std::vector<float> x;
  double sum = 0;  // whole numbers: exact in any order
  CHECK(dsp::energy(x) == 0);
  for (int i = 1; i <= 40; ++i) {
    x.push_back(static_cast<float>(i % 2 == 0 ? i : -i));
    sum += i * i;
    CHECK(dsp::energy(x) == sum);
  }
  for (std::size_t i : {std::size_t{3}, x.size() - 1}) {
    std::vector<float> wrong = x;
    wrong[i] = std::numeric_limits<float>::quiet_NaN();
    CHECK_FALSE(dsp::energy(wrong) <= 1e9);
  }
}
