#include "clicks/variance_model.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "analysis/noise.hpp"
#include "clicks/click_edit.hpp"
#include "clicks/envelope_fit.hpp"
#include "clicks/shift_search.hpp"

using namespace rigsound::analysis;

namespace {

const ClickEnvelope kModelShape{50, 0.02, 0.002};

/// v sample by sample from the definition, then averaged over blocks.
Eigen::ArrayXd direct_variance(const ModelClicks& clicks, const ClickEnvelope& shape, int block,
                               long length) {
  Eigen::ArrayXd v = Eigen::ArrayXd::Constant(length, clicks.floor);
  for (size_t i = 0; i < clicks.onset.size(); ++i)
    for (long n = std::max(0L, clicks.onset[i] * block); n < length * block; ++n)
      v(n / block) +=
          clicks.power(long(i)) * std::pow(envelope(shape, double(n - clicks.onset[i] * block)), 2) / block;
  return v;
}

ModelClicks some_clicks() {
  ModelClicks clicks;
  clicks.onset = {-3, 20, 21, 90, 240};
  clicks.power = (Eigen::ArrayXd(5) << 2, 1, 0.5, 3, 1.5).finished();
  clicks.floor = 0.1;
  return clicks;
}

Eigen::ArrayXd spread(const ModelClicks& clicks, const ClickEnvelope& shape, int block, long length) {
  Eigen::ArrayXd v;
  TrainPower(envelope_power(shape, block), clicks.onset, length).spread(clicks.power, clicks.floor, v);
  return v;
}

/// Blocks of noise of variance v, `block` samples each.
Eigen::ArrayXd noisy_blocks(const Eigen::ArrayXd& v, int block, TestNoise& noise) {
  Eigen::ArrayXd q(v.size());
  for (long n = 0; n < q.size(); ++n) q(n) = v(n) * noise.normals(block).square().mean();
  return q;
}

}  // namespace

TEST_CASE("the envelope is that of eq. 5 and 6") {
  CHECK(envelope(kModelShape, -1) == 0);
  CHECK(envelope(kModelShape, 0) == 0);
  CHECK(envelope(kModelShape, 50) == doctest::Approx(1));
  CHECK(envelope(kModelShape, 20) == doctest::Approx((1 - std::exp(-0.4)) / (1 - std::exp(-1.0))));
  CHECK(envelope(kModelShape, 550) == doctest::Approx(std::exp(-1.0)));
  CHECK(envelope({50, 0, 0.002}, 20) == doctest::Approx(0.4));
}

TEST_CASE("a bent attack rises in as many samples as its steepest slope takes from nothing to the peak") {
  for (const double bend : {-4.0, -1.0, 0.0, 1e-7, 0.5, 4.6}) {
    const ClickEnvelope shape{400, bend / 400, 0.001};
    double steepest = 0;
    for (double n = 0.1; n <= 400; n += 0.1)
      steepest = std::max(steepest, (envelope(shape, n) - envelope(shape, n - 0.1)) / 0.1);
    CAPTURE(bend);
    CHECK(rise_samples(shape) == doctest::Approx(1 / steepest).epsilon(0.003));
  }
}

TEST_CASE("carrying the tails gives the variance that adding every tail gives") {
  const ModelClicks clicks = some_clicks();
  for (const int block : {1, 2, 8}) {
    const Eigen::ArrayXd v = spread(clicks, kModelShape, block, 400);
    CHECK((v - direct_variance(clicks, kModelShape, block, 400)).abs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("weighing is the transpose of spreading") {
  TestNoise noise(61);
  const ModelClicks clicks = some_clicks();
  const TrainPower train(envelope_power(kModelShape, 8), clicks.onset, 400);
  const Eigen::ArrayXd q = 9 * noise.normals(400).square(), w = noise.normals(400).square() + 0.1;
  const Eigen::ArrayXd y = 1 / w, x = (q * y).min(5) * y;
  Eigen::ArrayXd v;
  train.spread(clicks.power, 0, v);
  const TrainSums sums = train.weigh(q, w, 5);
  CHECK((v * x).sum() == doctest::Approx((clicks.power * sums.x).sum()));
  CHECK((v * y).sum() == doctest::Approx((clicks.power * sums.y).sum()));
  CHECK(x.sum() == doctest::Approx(sums.all.first));
  CHECK(y.sum() == doctest::Approx(sums.all.second));
}

TEST_CASE("one logarithm for hundreds of factors is the sum of their logarithms") {
  TestNoise noise(62);
  const Eigen::ArrayXd w = (5 * noise.normals(10003)).exp(), q = (5 * noise.normals(10003)).exp();
  CHECK(divergence(q, w) == doctest::Approx((w.log() + q / w).sum()).epsilon(1e-12));
  CHECK(model_cost(q, w, 2) == doctest::Approx((w.log() + (q / w).min(kOutlierClip)).sum()).epsilon(1e-12));
}

TEST_CASE("multiplicative sweeps never make the model less likely and find the powers") {
  TestNoise noise(63);
  ModelClicks truth = some_clicks();
  const Eigen::ArrayXd q = noisy_blocks(spread(truth, kModelShape, 8, 400), 4000, noise);
  ModelClicks clicks = truth;
  clicks.power.setOnes();
  const TrainPower train(envelope_power(kModelShape, 8), clicks.onset, 400);
  update_powers(q, train, 1, 1e9, clicks);
  double last = 1e30;
  for (int sweep = 0; sweep < 100; ++sweep) {
    // The first sweep of a call takes the full ratio: a monotone path needs pairs of calls to be compared by
    // likelihood alone.
    Eigen::ArrayXd v;
    train.spread(clicks.power, clicks.floor, v);
    const double cost = model_cost(q, v, 8);
    CHECK(cost <= last + 1e-6);
    last = cost;
    update_powers(q, train, 2, 1e9, clicks);
  }
  CHECK(clicks.power(3) == doctest::Approx(3).epsilon(0.05));
  CHECK(clicks.floor == doctest::Approx(0.1).scale(0).epsilon(0.05));
}

TEST_CASE("the cost of a shift is that of the model with the click moved") {
  TestNoise noise(64);
  ModelClicks clicks = some_clicks();
  const Eigen::ArrayXd v = spread(clicks, kModelShape, 8, 400), q = noisy_blocks(v, 8, noise);
  const EnvelopePower shape = envelope_power(kModelShape, 8);
  const ShiftRange range{6, 2};
  const Eigen::ArrayXd costs =
      shift_costs(q, v, shape, sampled_power(shape), clicks.onset[3], clicks.power(3), range);
  REQUIRE(costs.size() == 7);
  const double here = divergence(q, v);
  for (long k = 0; k < 7; ++k) {
    ModelClicks moved = clicks;
    moved.onset[3] += 2 * k - 6;
    const double expected = divergence(q, spread(moved, kModelShape, 8, 400)) - here;
    CHECK(costs(k) - costs(3) == doctest::Approx(expected).epsilon(0.01).scale(1));
  }
}

TEST_CASE("a displaced click goes back to its place") {
  TestNoise noise(65);
  const ModelClicks truth = some_clicks();
  const Eigen::ArrayXd q = noisy_blocks(spread(truth, kModelShape, 8, 400), 400, noise);
  ModelClicks clicks = truth;
  clicks.onset[3] += 5;
  clicks.onset[4] -= 4;
  shift_clicks(q, envelope_power(kModelShape, 8), {6, 1}, clicks);
  CHECK(clicks.onset[3] == truth.onset[3]);
  CHECK(clicks.onset[4] == truth.onset[4]);
}

TEST_CASE("a removal costs half of what the likelihood loses, and an addition wins back what is missing") {
  TestNoise noise(66);
  const ModelClicks clicks = some_clicks();
  const Eigen::ArrayXd v = spread(clicks, kModelShape, 8, 400), q = noisy_blocks(v, 100, noise);
  const Eigen::ArrayXd a2 = sampled_power(envelope_power(kModelShape, 8));
  ModelClicks without = clicks;
  remove_click(without, 3);
  CHECK(without.onset == std::vector<long>{-3, 20, 21, 240});
  const Eigen::ArrayXd rest = spread(without, kModelShape, 8, 400);
  const double expected = 0.5 * 8 * 0.5 * (divergence(q, rest) - divergence(q, v));
  CHECK(removal_cost(q, v, a2, 90, 3, 8) == doctest::Approx(expected).epsilon(0.01));
  const Addition addition = best_addition(q, rest, a2, 92, 8);
  CHECK(addition.onset == 90);
  CHECK(addition.power == doctest::Approx(3).epsilon(0.1));
  CHECK(addition.gain > 0.95 * expected);
}

TEST_CASE("weak clicks go, missed ones come") {
  TestNoise noise(67);
  ModelClicks truth;
  for (long P = 20; P < 1200; P += 100) truth.onset.push_back(P);
  truth.power = Eigen::ArrayXd::Constant(12, 2);
  truth.floor = 0.1;
  const EnvelopePower shape = envelope_power(kModelShape, 8);
  const Eigen::ArrayXd q = noisy_blocks(spread(truth, kModelShape, 8, 1250), 8, noise);
  ModelClicks clicks = truth;
  clicks.onset.insert(clicks.onset.begin() + 4, 370);
  clicks.power = Eigen::ArrayXd::Constant(13, 2);
  clicks.power(4) = 0.03;
  remove_weak_clicks(q, shape, 100, 8, clicks);
  CHECK(clicks.onset == truth.onset);
  remove_click(clicks, 7);
  add_missed_clicks(q, shape, 100, 8, {372, 721, 770}, clicks);
  REQUIRE(clicks.onset.size() == 12);
  CHECK(std::labs(clicks.onset[7] - 720) <= 1);
}

TEST_CASE("the fit finds the envelope all clicks share") {
  TestNoise noise(68);
  const ClickEnvelope truth{60, 0, 0.0018};
  ModelClicks clicks;
  for (long P = 10; P < 12000; P += 200) clicks.onset.push_back(P);
  clicks.power = Eigen::ArrayXd::Constant(60, 4);
  clicks.floor = 0.02;
  const Eigen::ArrayXd q = noisy_blocks(spread(clicks, truth, 8, 12000), 8, noise);
  ClickEnvelope envelope = first_envelope(q, clicks.onset, 1600, 8);
  fit_envelope(q, 1600, {8, 200, 3}, envelope, clicks);
  CHECK(envelope.decay == doctest::Approx(0.0018).scale(0).epsilon(0.05));
  CHECK(envelope.attack_samples > 35);
  CHECK(envelope.attack_samples < 100);
}
