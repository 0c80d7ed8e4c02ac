#include "rigsound/log/log_clock.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace rigsound;

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// Times in ms of entries stamped `stamps_ms`.
std::vector<double> placed(const std::vector<double>& stamps_ms, log::LogClock& clock) {
  std::vector<double> times;
  const auto ns = [](double ms) { return static_cast<std::int64_t>(ms * 1e6); };
  for (std::size_t i = 0; i < stamps_ms.size(); ++i) {
    const bool last = i + 1 == stamps_ms.size();
    const auto next = last ? std::nullopt : std::optional<std::int64_t>(ns(stamps_ms[i + 1]));
    times.push_back(static_cast<double>(clock.place(ns(stamps_ms[i]), next, static_cast<int>(i) + 1)) * 1e-6);
  }
  return times;
}

std::vector<double> placed(const std::vector<double>& stamps_ms) {
  log::LogClock clock;
  return placed(stamps_ms, clock);
}

using Times = std::vector<double>;

}  // namespace

TEST_CASE("A clock that goes right is left alone") {
  CHECK(placed({5000, 5010, 5010, 5500, 3605500}) == Times{0, 10, 10, 500, 3600500});
}

TEST_CASE("A clock that was set, forward or back, goes on from there") {
  log::LogClock forward, back;
  CHECK(placed({0, 10, 1e12, 1e12 + 10, 1e12 + 30}, forward) == Times{0, 10, 20, 30, 50});
  REQUIRE(forward.notes().size() == 1);
  CHECK(forward.notes()[0].line == 3);
  CHECK(placed({90000, 90010, 10, 20, 40}, back) == Times{0, 10, 20, 30, 50});
  REQUIRE(back.notes().size() == 1);
  CHECK(back.notes()[0].text.find("backwards by 90.0 s") != std::string::npos);
}

TEST_CASE("A pause of a day is one, a longer one is a clock that was set") {
  constexpr double kDay_ms = 86'400'000;
  CHECK(placed({0, 10, 10 + kDay_ms}) == Times{0, 10, 10 + kDay_ms});
  CHECK(placed({0, 10, 11 + kDay_ms}) == Times{0, 10, 20});
}

TEST_CASE("A stamp that alone is wrong lies between its neighbours") {
  for (const double wrong : {0.0, 5000.0, 1e12}) {
    CAPTURE(wrong);
    log::LogClock clock;
    CHECK(placed({1000, 1010, wrong, 1030, 1040}, clock) == Times{0, 10, 20, 30, 40});
    REQUIRE(clock.notes().size() == 1);
    CHECK(clock.notes()[0].text.find("1 stamps alone are wrong") == 0);
  }
}

TEST_CASE("Late entries of another source move nothing") {
  log::LogClock clock;
  const Times times = placed({1000, 1010, 1009, 1020, 1030}, clock);
  CHECK(times.front() == 0);
  CHECK(times.back() == 30);
  for (std::size_t i = 1; i < times.size(); ++i) CHECK(times[i] >= times[i - 1]);
}

TEST_CASE("Pauses over the limit are left out") {
  log::LogClock clock(2.0);
  CHECK(placed({0, 10, 5010, 5020, 7020, 9021}, clock) == Times{0, 10, 20, 30, 2030, 3030});
  CHECK(clock.notes().back().text.find("2 pauses were left out, the first of 5.0 s") == 0);
}

TEST_CASE("Whatever the stamps, time never runs back nor over its end") {
  std::mt19937_64 random(1);
  log::LogClock clock;
  std::int64_t last = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto stamp = static_cast<std::int64_t>(random() % (9'000'000'000ULL * 1'000'000'000ULL));
    const auto next = static_cast<std::int64_t>(random() % (9'000'000'000ULL * 1'000'000'000ULL));
    const std::int64_t now = clock.place(stamp, next, i);
    REQUIRE(now >= last);
    REQUIRE(now <= 9'000'000'000 * kSecond);
    last = now;
  }
}
