#include "diesel/angle_reader.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rigsound/dsp/elementary.hpp"

using namespace rigsound;
using diesel::AngleReader;

namespace {

float value_at(const AngleReader& reader, const std::vector<float>& x, int sample, double fraction) {
  return dsp::total(AngleReader::read(reader.weights(fraction), x.data() + sample + AngleReader::kFirst));
}

}  // namespace

TEST_CASE("between its samples a sine up to a quarter of their rate is that sine") {
  const AngleReader reader;
  for (const double cycles : {0.003, 0.05, 0.15, 0.25}) {
    std::vector<float> x(64);
    for (std::size_t n = 0; n < x.size(); ++n)
      x[n] = static_cast<float>(std::sin(dsp::kTwoPi * cycles * static_cast<double>(n)));
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double fraction = std::min(i / 1000.0, 0.999999);
      worst = std::max(worst, std::fabs(static_cast<double>(value_at(reader, x, 30, fraction)) -
                                        std::sin(dsp::kTwoPi * cycles * (30 + fraction))));
    }
    CHECK_MESSAGE(worst < 1.2e-4, cycles);  // -78 dB, of the highest
  }
}

TEST_CASE("on a sample it reads that sample, and a constant everywhere") {
  const AngleReader reader;
  std::vector<float> x(40, 0.0F);
  x[20] = 1;
  CHECK(value_at(reader, x, 20, 0) == doctest::Approx(1).epsilon(1e-6));
  CHECK(std::fabs(value_at(reader, x, 19, 0)) < 1e-6F);
  CHECK(value_at(reader, x, 19, 0.9999999) == doctest::Approx(1).epsilon(1e-5));
  std::fill(x.begin(), x.end(), 0.5F);
  for (const double fraction : {0.0, 0.1234, 0.5, 0.75, 0.9961, 0.9999})
    CHECK(value_at(reader, x, 20, fraction) == doctest::Approx(0.5).epsilon(1e-6));
}
