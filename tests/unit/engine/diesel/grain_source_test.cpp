// Cycles of a clean recording: which are drawn, and how they overlap.
#include "diesel/grain_source.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <tuple>
#include <vector>

using namespace rigsound;
using namespace rigsound::diesel;

namespace {

/// Points whose grains hold nothing but a number of their own: 10 times the point's and the grain's.
DieselModel numbered(const std::vector<std::pair<double, double>>& places, int grains) {
  DieselModel m;
  m.angle_samples = 1024, m.slots = 64;
  for (const auto& [rpm, load] : places) {
    DieselPoint p;
    p.rpm = rpm, p.load = load;
    for (int g = 0; g < grains; ++g)
      p.grains.emplace_back(1280,
                            static_cast<float>(10 * (m.points.size() + 1) + static_cast<std::size_t>(g)));
    m.points.push_back(p);
  }
  return m;
}

/// The number of the grain in each cycle, read behind the overlap.
std::vector<int> drawn(const DieselModel& m, double rpm, double load, int cycles) {
  GrainSource source(m, 5);
  std::vector<int> numbers;
  double out[16];
  for (int c = 0; c < cycles; ++c)
    for (int slot = 0; slot < 64; ++slot) {
      source.produce(rpm, load, out);
      if (slot == 40) numbers.push_back(static_cast<int>(std::lround(out[3])));
    }
  return numbers;
}

double share_of_point(const std::vector<int>& numbers, int point) {
  double count = 0;
  for (const int n : numbers) count += n / 10 == point;
  return count / static_cast<double>(numbers.size());
}

}  // namespace

TEST_CASE("at a point only its own grains are drawn, all of them, never one twice in a row") {
  const DieselModel m = numbered({{800, 0}, {1600, 0}, {800, 1}}, 4);
  for (const auto& [point, rpm, load] :
       {std::tuple{1, 800.0, 0.0}, std::tuple{2, 1600.0, 0.0}, std::tuple{3, 800.0, 1.0}}) {
    const std::vector<int> numbers = drawn(m, rpm, load, 200);
    CHECK(share_of_point(numbers, point) == 1);
    CHECK(std::set<int>(numbers.begin(), numbers.end()).size() == 4);
    for (std::size_t i = 1; i < numbers.size(); ++i) CHECK(numbers[i] != numbers[i - 1]);
  }
}

TEST_CASE(
    "between two points both are drawn, the nearer one the more often: an octave is as far as a load of 1") {
  const DieselModel m = numbered({{800, 0}, {1600, 0}, {800, 1}}, 3);
  const auto share = [&](double rpm, double load, int point) {
    return share_of_point(drawn(m, rpm, load, 3000), point);
  };
  CHECK(share(800 * std::sqrt(2.0), 0, 1) == doctest::Approx(0.5).epsilon(0.06));
  CHECK(share(800 * std::pow(2, 0.25), 0, 1) == doctest::Approx(0.75).epsilon(0.05));
  CHECK(share(800, 0.25, 1) == doctest::Approx(0.75).epsilon(0.05));
  CHECK(share(800, 0.25, 3) == doctest::Approx(0.25).epsilon(0.1));
  CHECK(share(800, 0.8, 3) == doctest::Approx(0.8).epsilon(0.05));
  CHECK(share(800 * std::pow(2, 0.6), 0.1, 2) > share(800 * std::pow(2, 0.4), 0.1, 2));
}

TEST_CASE("a point's only grain may follow itself") {
  const std::vector<int> numbers = drawn(numbered({{800, 0}}, 1), 800, 0, 5);
  CHECK(numbers == std::vector<int>{10, 10, 10, 10, 10});
}

TEST_CASE("grains overlap over a quarter of a cycle with equal power, the first one begins at once") {
  DieselModel m = numbered({{800, 0}}, 1);
  for (std::size_t i = 0; i < m.points[0].grains[0].size(); ++i)
    m.points[0].grains[0][i] = i < 1024 ? 1.0F : 2.0F;  // what follows the cycle can be told apart
  GrainSource source(m, 5);
  std::vector<double> out(3072);
  for (std::size_t n = 0; n < out.size(); n += 16) source.produce(800, 0, &out[n]);
  for (std::size_t n = 0; n < 1024; ++n) CHECK(out[n] == 1);
  for (std::size_t n = 0; n < 256; ++n) {
    const double in = std::sin(M_PI / 2 * (static_cast<double>(n) + 0.5) / 256);
    CHECK(out[1024 + n] == doctest::Approx(in + 2 * std::sqrt(1 - in * in)).epsilon(1e-9));
    CHECK(out[2048 + n] == doctest::Approx(out[1024 + n]).epsilon(1e-12));
  }
  for (std::size_t n = 256; n < 1024; ++n) CHECK(out[1024 + n] == 1);
}
