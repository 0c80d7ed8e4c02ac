#include "denoise/paper_nmf.hpp"

#include <doctest/doctest.h>

#include "analysis/noise.hpp"
#include "kernels/kl_kernels.hpp"

using namespace rigsound::analysis;

namespace {

Eigen::MatrixXf positive(long rows, long columns, TestNoise& noise) {
  Eigen::MatrixXf x(rows, columns);
  for (float& value : x.reshaped()) value = float(noise.uniform()) + 0.05f;
  return x;
}

PaperFactors factors(TestNoise& noise) { return {positive(30, 6, noise), positive(6, 50, noise)}; }

double kullback_leibler(const Eigen::MatrixXf& V, const PaperFactors& f) {
  const Eigen::ArrayXXd v = V.cast<double>().array(), L = (f.W * f.H).cast<double>().array();
  return (v * (v / L).log() - v + L).sum();
}

}  // namespace

TEST_CASE("the fused updates are Lee and Seung's") {
  TestNoise noise(21);
  const Eigen::MatrixXf V = positive(30, 50, noise);
  PaperFactors f = factors(noise);
  const Eigen::MatrixXf quotient = (V.array() / (f.W * f.H).array()).matrix();
  const Eigen::MatrixXf H = (f.H.array() * (f.W.transpose() * quotient).array()).array().colwise() /
                            f.W.colwise().sum().transpose().array();
  kl_kernels().update_activations({V.data(), f.W.data(), f.H.data(), 30, 50, 6});
  CHECK((f.H - H).cwiseAbs().maxCoeff() < 1e-5f);
  const Eigen::MatrixXf again = (V.array() / (f.W * f.H).array()).matrix();
  const Eigen::MatrixXf W = (f.W.array() * (again * f.H.transpose()).array()).array().rowwise() /
                            f.H.rowwise().sum().transpose().array();
  kl_kernels().update_words({V.data(), f.W.data(), f.H.data(), 30, 50, 6});
  CHECK((f.W - W).cwiseAbs().maxCoeff() < 1e-5f);
}

TEST_CASE("no update makes the divergence larger") {
  TestNoise noise(22);
  const Eigen::MatrixXf V = positive(30, 300, noise);
  PaperFactors f{positive(30, 6, noise), positive(6, 300, noise)};
  double last = kullback_leibler(V, f);
  for (int i = 0; i < 20; ++i) {
    kl_kernels().update_activations({V.data(), f.W.data(), f.H.data(), 30, 300, 6});
    const double half = kullback_leibler(V, f);
    kl_kernels().update_words({V.data(), f.W.data(), f.H.data(), 30, 300, 6});
    const double now = kullback_leibler(V, f);
    CHECK(half <= last * (1 + 1e-5));
    CHECK(now <= half * (1 + 1e-5));
    last = now;
  }
}

TEST_CASE("energies from Gram matrices are those of the products") {
  TestNoise noise(23);
  const PaperFactors f = factors(noise);
  const Eigen::MatrixXd V_n = (f.W.leftCols(2) * f.H.topRows(2)).cast<double>();
  const Eigen::MatrixXd V_s = (f.W.rightCols(4) * f.H.bottomRows(4)).cast<double>();
  const ModelEnergies energies = model_energies(f, 2);
  CHECK(energies.E_n == doctest::Approx(V_n.squaredNorm()).epsilon(1e-5));
  CHECK(energies.E_s == doctest::Approx(V_s.squaredNorm()).epsilon(1e-5));
  CHECK(energies.C == doctest::Approx(V_n.cwiseProduct(V_s).sum()).epsilon(1e-5));
}

TEST_CASE("the constraint meets the ratio and the total energy at once") {
  TestNoise noise(24);
  PaperFactors f = factors(noise);
  constrain_snr(2.5, 77, 2, f);
  const ModelEnergies energies = model_energies(f, 2);
  CHECK(energies.E_s / energies.E_n == doctest::Approx(2.5).epsilon(1e-4));
  CHECK((f.W * f.H).cast<double>().squaredNorm() == doctest::Approx(77).epsilon(1e-4));
}

TEST_CASE("the smoothing is 3 dB down at its corner and leaves a constant alone") {
  const double rate = 375, f_c = 2;
  Eigen::MatrixXf rows(2, 3000);
  for (int n = 0; n < 3000; ++n) rows(0, n) = float(1 + std::cos(2 * kPi * f_c * n / rate)), rows(1, n) = 5;
  smooth_rows(f_c, rate, rows);
  const auto middle = rows.row(0).segment(1000, 1000);
  CHECK((middle.maxCoeff() - middle.minCoeff()) / 2 == doctest::Approx(std::sqrt(0.5)).epsilon(0.01));
  CHECK(rows.row(1).minCoeff() == doctest::Approx(5));
  CHECK(rows.row(1).maxCoeff() == doctest::Approx(5));
}

TEST_CASE("the words of a factorisation have norm one and its model the energy of the spectrogram") {
  TestNoise noise(25);
  const Eigen::MatrixXf V = positive(40, 200, noise);
  PaperNmfOptions options;
  options.K = 6;
  options.Q_1 = 5;
  options.Q_2 = 0;
  const PaperFactors f = paper_nmf(V, options);
  for (int k = 0; k < 6; ++k) CHECK(f.W.col(k).norm() == doctest::Approx(1).epsilon(1e-4));
  CHECK((f.W * f.H).squaredNorm() == doctest::Approx(V.squaredNorm()).epsilon(1e-3));
}
