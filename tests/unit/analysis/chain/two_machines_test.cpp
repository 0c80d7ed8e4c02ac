// Two machines that strike at rates of their own: both are found, and either is had without the other.
#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "analysis/f_measure.hpp"
#include "analysis/noise.hpp"
#include "chain/machines.hpp"
#include "chain/second_machine.hpp"
#include "clicks/envelope.hpp"
#include "clicks/known_train.hpp"
#include "rigsound/analysis/chain.hpp"

using namespace rigsound::analysis;

namespace {

constexpr double kSeconds = 4;
constexpr auto kLength = static_cast<std::size_t>(kSeconds * 48000);

struct Struck {
  std::vector<int> P;
  std::vector<float> sound;  ///< RMS 1
};

/// Decaying noise at 4 % jitter through one resonance: no other machine sounds the same.
Struck machine(double rate_hz, double resonance_hz, unsigned seed) {
  TestNoise noise(seed);
  Struck s;
  Eigen::ArrayXd x = Eigen::ArrayXd::Zero(kLength);
  const double T = 48000 / rate_hz;
  for (double t = 0.4 * T; t + 1 < double(kLength); t += T * (1 + 0.04 * noise.normal())) {
    s.P.push_back(int(t));
    const double strength = std::max(0.3, 1 + 0.2 * noise.normal());
    for (long n = 0; n < long(T) && s.P.back() + n < x.size(); ++n)
      x(s.P.back() + n) += strength * std::exp(-3 * double(n) / T) * noise.normal();
  }
  const double pole = 0.97, w = 2 * kPi * resonance_hz / 48000;
  double y1 = 0, y2 = 0, square = 0;
  for (const double sample : x) {
    const double y = sample + 2 * pole * std::cos(w) * y1 - pole * pole * y2;
    y2 = y1, y1 = y;
    square += y * y;
    s.sound.push_back(float(y));
  }
  for (float& y : s.sound) y /= float(std::sqrt(square / kLength));
  return s;
}

std::vector<float> mixed(const Struck& a, const Struck& b, double b_db) {
  TestNoise noise(9);
  std::vector<float> x;
  for (std::size_t n = 0; n < kLength; ++n)
    x.push_back(float(0.05 * (a.sound[n] + std::pow(10, b_db / 20) * b.sound[n] + 0.5 * noise.normal())));
  return x;
}

std::vector<float> alone(const Struck& a) { return mixed(a, a, -200); }

ChainResult found_in(const std::vector<float>& x, int which) {
  ChainOptions options;
  options.machine = which;
  return run_chain(x, options);
}

double correlation(const std::vector<float>& a, const std::vector<float>& b) {
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    ab += double(a[n]) * b[n], aa += double(a[n]) * a[n], bb += double(b[n]) * b[n];
  return ab / std::sqrt(aa * bb);
}

const Struck& slow() {
  static const Struck s = machine(21, 900, 1);
  return s;
}
const Struck& fast() {
  static const Struck s = machine(34, 4000, 2);
  return s;
}

ClickTrain train_at(std::vector<int> P, double T_0) {
  ClickTrain train;
  train.beta.assign(P.size(), 1.0);
  train.P = std::move(P);
  train.mean_gap_samples = T_0;
  train.envelope = {40, 0, 3 / T_0};
  return train;
}

}  // namespace

TEST_CASE("two machines are named with their rates, the louder first, and every click with its machine") {
  const ChainResult both = found_in(mixed(slow(), fast(), -3), 0);
  REQUIRE(both.machines.size() == 2);
  CHECK(both.machines[0].rate_hz == doctest::Approx(21).epsilon(0.02));
  CHECK(both.machines[1].rate_hz == doctest::Approx(34).epsilon(0.02));
  CHECK(both.machines[0].level_db > both.machines[1].level_db);
  REQUIRE(both.struck_by.size() == both.clicks.P.size());
  CHECK(both.machines[0].clicks + both.machines[1].clicks == both.clicks.P.size());
  CHECK(machines_text(both.machines).find("machine 2: 3") != std::string::npos);
}

TEST_CASE("a second machine that the blind split only lets suspect is found" * doctest::test_suite("long")) {
  for (const unsigned seed : {2U, 4U}) {
    const Struck a = machine(21, 900, seed), b = machine(34, 4000, 100 + seed);
    const std::vector<float> x = mixed(a, b, 0);
    ChainResult first = found_in(x, 1), second = found_in(x, 2);
    REQUIRE(second.drilling_found);
    if (first.clicks.mean_gap_samples < second.clicks.mean_gap_samples) std::swap(first, second);
    CHECK(f_measure(first.clicks.P, a.P) > 0.9);
    CHECK(f_measure(second.clicks.P, b.P) > 0.9);
  }
}

TEST_CASE("one machine is had without the other" * doctest::test_suite("long")) {
  const std::vector<float> x = mixed(slow(), fast(), -3);
  const ChainResult first = found_in(x, 1), second = found_in(x, 2);
  CHECK(first.struck_by.empty());
  CHECK(f_measure(first.clicks.P, slow().P) > 0.95);
  CHECK(f_measure(second.clicks.P, fast().P) > 0.9);
  CHECK(correlation(first.drilling.all(), slow().sound) > 0.9);
  CHECK(std::fabs(correlation(first.drilling.all(), fast().sound)) < 0.15);
  CHECK(correlation(second.drilling.all(), fast().sound) > 0.85);
  CHECK(std::fabs(correlation(second.drilling.all(), slow().sound)) < 0.2);
  const ChainResult all = found_in(x, 0);
  for (std::size_t n = 0; n < kLength; n += 997)
    CHECK(all.drilling.all()[n] ==
          doctest::Approx(first.drilling.all()[n] + second.drilling.all()[n]).epsilon(1e-5));
}

TEST_CASE("one machine is one, and whoever asks for a second is told") {
  const std::vector<float> x = alone(fast());
  CHECK(found_in(x, 0).machines.size() == 1);
  CHECK(found_in(x, 0).struck_by.empty());
  const ChainResult none = found_in(x, 2);
  CHECK(!none.drilling_found);
  CHECK(none.clicks.P.empty());
  CHECK(none.reason.find("there is no machine 2, only one of 3") != std::string::npos);
}

TEST_CASE("echoes and double impacts keep their phase, another machine does not") {
  std::vector<int> echo, twice;
  for (const int P : slow().P) echo.push_back(P + 700), twice.push_back(P), twice.push_back(P + 1100);
  const ClickTrain train = train_at(slow().P, 48000 / 21.0);
  CHECK(phase_locking(train, train_at(echo, train.mean_gap_samples)) > 0.9);
  CHECK(phase_locking(train, train_at(twice, train.mean_gap_samples / 2)) > 0.6);
  CHECK(phase_locking(train, train_at(fast().P, 48000 / 34.0)) < 0.35);
}

TEST_CASE("a known train is heard with the powers it has in another signal") {
  const ClickTrain train = train_at(slow().P, 48000 / 21.0);
  TestNoise noise(3);
  Eigen::ArrayXd power = Eigen::ArrayXd::Constant(kLength, 0.25);
  for (const int P : train.P)
    for (long n = P; n < long(kLength); ++n) {
      const double a = envelope(train.envelope, double(n - P));
      if (n - P > 9000) break;
      power(n) += 4 * a * a;
    }
  const HeardTrain heard = hear_train(noise.normals(kLength) * power.sqrt(), train);
  CHECK(heard.floor == doctest::Approx(0.25).scale(0).epsilon(0.1));
  CHECK((heard.variance / (power - 0.25).max(1e-9)).segment(20000, 40000).mean() ==
        doctest::Approx(1).epsilon(0.1));
}

TEST_CASE("trains keep their machine from segment to segment by their rate, the loudest machine first") {
  const auto of = [](double gap, double psd) {
    ChainResult r;
    r.drilling_found = true;
    r.clicks.mean_gap_samples = gap;
    r.signal_psd = {psd}, r.noise_psd = {1}, r.output_psd = {psd};
    return r;
  };
  const auto machines =
      by_machine({{of(2300, 1)}, {of(1400, 3), of(2250, 1)}, {of(2200, 1), of(1450, 3)}, {of(1390, 3)}});
  REQUIRE(machines.size() == 2);
  for (const std::size_t k : {1, 2, 3}) CHECK(machines[0][k].clicks.mean_gap_samples < 1500);
  for (const std::size_t k : {0, 1, 2}) CHECK(machines[1][k].clicks.mean_gap_samples > 2100);
  CHECK(!machines[0][0].drilling_found);
  CHECK(machines[0][0].noise_psd[0] == doctest::Approx(2));
  CHECK(!machines[1][3].drilling_found);
}
