#include "denoise/paper_nmf.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "kernels/kl_kernels.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr float kMagnitudeFloor = 1e-6f;  // of the mean

PaperFactors random_start(const Eigen::MatrixXf& V, const PaperNmfOptions& options) {
  std::mt19937_64 bits(options.seed);
  const auto uniform = [&bits](float) {
    return static_cast<float>(static_cast<double>(bits() >> 11) * 0x1p-53) + 0.1f;
  };
  PaperFactors f;
  f.W = Eigen::MatrixXf(V.rows(), options.K).unaryExpr(uniform);
  f.H = Eigen::MatrixXf(options.K, V.cols()).unaryExpr(uniform);
  const double mean = f.W.colwise().sum().cast<double>().dot(f.H.rowwise().sum().cast<double>()) /
                      static_cast<double>(V.size());
  f.H *= static_cast<float>(V.cast<double>().mean() / mean);
  return f;
}

/// lambda_k = norm of column k (not its square): W Lambda^-1, Lambda H.
void normalise(PaperFactors& f) {
  const Eigen::VectorXf lambda = f.W.colwise().norm().transpose();
  f.W.array().rowwise() /= lambda.transpose().array();
  f.H.array().colwise() *= lambda.array();
}

Factorisation view(const Eigen::MatrixXf& V, PaperFactors& f) {
  return {V.data(),
          f.W.data(),
          f.H.data(),
          static_cast<int>(V.rows()),
          static_cast<int>(V.cols()),
          static_cast<int>(f.W.cols())};
}

}  // namespace

void smooth_rows(double f_c, double frame_rate, Eigen::Ref<Eigen::MatrixXf> rows) {
  const double sigma = frame_rate * std::sqrt(std::log(2.0)) / (2 * static_cast<double>(EIGEN_PI) * f_c);
  const long reach = static_cast<long>(4 * sigma + 0.5), frames = rows.cols();
  const Eigen::ArrayXd offset =
      Eigen::ArrayXd::LinSpaced(2 * reach + 1, static_cast<double>(-reach), static_cast<double>(reach));
  Eigen::ArrayXd kernel = (-0.5 * (offset / sigma).square()).exp();
  kernel /= kernel.sum();
  Eigen::ArrayXd held(frames + 2 * reach);
  for (long k = 0; k < rows.rows(); ++k) {
    held.head(reach) = rows(k, 0);
    held.segment(reach, frames) = rows.row(k).transpose().cast<double>().array();
    held.tail(reach) = rows(k, frames - 1);
    for (long n = 0; n < frames; ++n)
      rows(k, n) = static_cast<float>((held.segment(n, 2 * reach + 1) * kernel).sum());
  }
}

ModelEnergies model_energies(const PaperFactors& f, int K_n) {
  const Eigen::MatrixXd W = f.W.cast<double>(), H = f.H.cast<double>();
  const Eigen::MatrixXd product = (W.transpose() * W).cwiseProduct(H * H.transpose());
  const long K_s = product.rows() - K_n;
  return {product.topLeftCorner(K_n, K_n).sum(), product.bottomRightCorner(K_s, K_s).sum(),
          product.topRightCorner(K_n, K_s).sum()};
}

void constrain_snr(double sigma, double energy, int K_n, PaperFactors& f) {
  const auto [E_n, E_s, C] = model_energies(f, K_n);
  const double r = std::sqrt(sigma * E_n / E_s);
  const double alpha_n = std::sqrt(energy / (E_n + r * r * E_s + 2 * r * C));
  f.H.topRows(K_n) *= static_cast<float>(alpha_n);
  f.H.bottomRows(f.H.rows() - K_n) *= static_cast<float>(r * alpha_n);
}

PaperFactors paper_nmf(const Eigen::MatrixXf& V, const PaperNmfOptions& options) {
  const double frame_rate = kAnalysisRate / kPaperStft.hop, energy = V.cast<double>().squaredNorm();
  PaperFactors f = random_start(V, options);
  for (int q = 0; q < options.Q_1 + options.Q_2; ++q) {
    kl_kernels().update_activations(view(V, f));
    smooth_rows(options.f_c, frame_rate, f.H.topRows(options.K_n));
    kl_kernels().update_words(view(V, f));
    normalise(f);
    if (q < options.Q_1) constrain_snr(options.sigma, energy, options.K_n, f);
  }
  return f;
}

Spectrogram paper_drilling(const Spectrogram& X, const PaperNmfOptions& options) {
  const Grid magnitude = X.abs();
  const float scale = magnitude.mean();
  const Eigen::MatrixXf V = (magnitude / scale).max(kMagnitudeFloor).matrix();
  const PaperFactors f = paper_nmf(V, options);
  const long K_s = options.K - options.K_n;
  const Grid V_s = (f.W.rightCols(K_s) * f.H.bottomRows(K_s)).array() * scale;
  return X * (V_s / magnitude.max(kMagnitudeFloor * scale)).cast<std::complex<float>>();
}

}  // namespace rigsound::analysis
