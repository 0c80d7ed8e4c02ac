// Distances and rates of sounds that are known, and what a listener makes of them.
#include "contrast/listening.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "analysis/contrast/impact_sounds.hpp"
#include "contrast/discriminant.hpp"
#include "contrast/impact_rate.hpp"

using namespace rigsound::analysis;
using rigsound::dsp::RandomField;

TEST_CASE("a sound that is three decibels louder is three decibels away in third octaves and nowhere else") {
  const std::vector<float> quiet = impact_sound({}, 20, 1);
  std::vector<float> loud = quiet;
  for (float& x : loud) x *= static_cast<float>(std::pow(10, 3 / 20.0));
  const Distance d = distance(listen(quiet), listen(loud));
  CHECK(d.third_octave_db == doctest::Approx(3).epsilon(0.001));
  CHECK(d.modulation_db < 1e-3);
  CHECK(d.rate < 1e-3);
}

TEST_CASE("levels that nobody hears do not count") {
  const std::vector<float> silence(48000), faint(48000, 1e-9F);
  CHECK(distance(listen(silence), listen(faint)).third_octave_db == 0);
}

TEST_CASE(
    "the rate of impacts is found, be it slow or fast, scattered, ringing long, echoing, or under a diesel") {
  for (const double rate_hz : {6.0, 17.3, 41.0, 58.0, 102.0})
    for (const double scatter : {0.0, 0.03, 0.1}) {
      CAPTURE(rate_hz);
      CAPTURE(scatter);
      ImpactSound sound;
      sound.rate_hz = rate_hz, sound.scatter = scatter;
      // The gaps that were drawn have a mean of their own.
      CHECK(impact_rate_hz(impact_sound(sound, 20, 1)) ==
            doctest::Approx(rate_hz).epsilon(scatter > 0.05 ? 0.03 : 0.005));
      if (rate_hz > 10 && scatter < 0.05)  // few impacts that scatter do not say much
        CHECK(impact_rate_hz(impact_sound(sound, 1, 2)) == doctest::Approx(rate_hz).epsilon(0.03));
    }
  ImpactSound ringing;
  ringing.decay_s = 0.06;
  CHECK(impact_rate_hz(impact_sound(ringing, 20, 3)) == doctest::Approx(ringing.rate_hz).epsilon(0.015));
  ImpactSound missing;
  missing.missing = 0.15;
  CHECK(impact_rate_hz(impact_sound(missing, 20, 4)) == doctest::Approx(missing.rate_hz).epsilon(0.015));
  std::vector<float> echoing = impact_sound({}, 20, 6);
  for (std::size_t n = echoing.size(); n-- > 520;) echoing[n] += 0.9F * echoing[n - 520];
  CHECK(impact_rate_hz(echoing) == doctest::Approx(ImpactSound().rate_hz).epsilon(0.015));
  std::vector<float> diesel = impact_sound({}, 20, 5);
  for (std::size_t n = 0; n < diesel.size(); ++n)
    for (const double order : {1.0, 6.0, 12.0})
      diesel[n] += static_cast<float>(0.1 * std::sin(2 * kPi * 15 * order * static_cast<double>(n) / 48000));
  CHECK(impact_rate_hz(diesel) == doctest::Approx(ImpactSound().rate_hz).epsilon(0.015));
}

TEST_CASE("noise has no rate") {
  TestNoise noise(1);
  CHECK(impact_rate_hz(samples(noise.normals(960000) * 0.1)) == 0);
  CHECK(impact_rate_hz(std::vector<float>(48000)) == 0);
}

TEST_CASE("the ear's noise is drawn anew for every excerpt and every feature, and the same every time") {
  const Heard heard = listen(impact_sound({}, 1, 1));
  const RandomField ear(1, 2, 3);
  const Eigen::VectorXd first = noticed(heard, ear, 0), second = noticed(heard, ear, 1);
  CHECK(first == noticed(heard, ear, 0));
  const Eigen::ArrayXd difference = first - second;
  CHECK((difference.abs() > 1e-12).all());
  // 25 levels of 2 dB each: their difference has 2.8 dB.
  CHECK(std::sqrt(difference.head(25).square().mean()) == doctest::Approx(2.83).scale(0).epsilon(0.4));
}

namespace {

/// Points about 0 or, along one of ten features, about `apart`, in parts.
std::vector<Eigen::MatrixXd> points(double apart, unsigned seed) {
  std::vector<Eigen::MatrixXd> parts;
  TestNoise noise(seed);
  for (int part = 0; part < 4; ++part) {
    Eigen::MatrixXd x(10, 100);
    for (long i = 0; i < x.cols(); ++i) x.col(i) = noise.normals(10).matrix();
    x.row(3).array() += apart;
    x.row(4) *= 1000;  // another unit
    parts.push_back(x);
  }
  return parts;
}

double share(const Judged& judged) { return static_cast<double>(judged.right) / judged.of; }

}  // namespace

TEST_CASE("two kinds that lie d apart are told right as often as theory has it") {
  // Best possible: the normal distribution at d / 2.
  CHECK(share(cross_validated(points(0, 1), points(0, 2))) == doctest::Approx(0.5).epsilon(0.08));
  CHECK(share(cross_validated(points(1.349, 1), points(0, 2))) == doctest::Approx(0.75).epsilon(0.05));
  CHECK(share(cross_validated(points(3.29, 1), points(0, 2))) == doctest::Approx(0.95).epsilon(0.02));
  CHECK(share(cross_validated(points(20, 1), points(0, 2))) == 1);
}

TEST_CASE("fewer examples than features do not make a listener who only thinks he hears") {
  std::vector<Eigen::MatrixXd> a, b;
  TestNoise noise(5);
  for (int part = 0; part < 4; ++part)
    for (auto* parts : {&a, &b}) {
      Eigen::MatrixXd x(45, 5);
      for (long i = 0; i < x.cols(); ++i) x.col(i) = noise.normals(45).matrix();
      parts->push_back(x);
    }
  CHECK(share(cross_validated(a, b)) < 0.7);
}
