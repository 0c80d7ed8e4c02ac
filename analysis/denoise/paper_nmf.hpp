// The drilling paper's own denoiser (section 2), its errors of print corrected.
#pragma once

#include <Eigen/Core>

#include "spectrum/stft.hpp"

namespace rigsound::analysis {

/// Section 2.3's parameters.
struct PaperNmfOptions {
  int K = 82;         ///< words
  int K_n = 2;        ///< of them the background's, first
  double f_c = 2;     ///< Hz, -3 dB of the smoothing of the background's activations
  int Q_1 = 100;      ///< iterations with smoothing and SNR constraint
  int Q_2 = 100;      ///< iterations with smoothing alone
  double sigma = 1;   ///< signal-to-noise ratio of the constraint
  unsigned seed = 0;  ///< of the random start
};

struct PaperFactors {
  Eigen::MatrixXf W;  ///< M x K, columns of unit norm
  Eigen::MatrixXf H;  ///< K x N
};

/// Kullback-Leibler NMF of V (M x N magnitudes) with a slow background. Thread: OFF.
PaperFactors paper_nmf(const Eigen::MatrixXf& V, const PaperNmfOptions& options);

/// Energies of the two parts of a model and their inner product, from K x K Gram matrices instead of M x N
/// products: E{V_n}, E{V_s}, <V_s, V_n>.
struct ModelEnergies {
  double E_n = 0, E_s = 0, C = 0;
};
ModelEnergies model_energies(const PaperFactors& factors, int K_n);

/// Scales H so that E{V_s} = sigma E{V_n} and E{V_s + V_n} = energy: eq. 2 and 3 with the cross term that
/// magnitudes need.
void constrain_snr(double sigma, double energy, int K_n, PaperFactors& factors);

/// Each row smoothed in time by a Gaussian of -3 dB at f_c (Hz; `frame_rate` Hz), edges held. Non-negative
/// rows stay so.
void smooth_rows(double f_c, double frame_rate, Eigen::Ref<Eigen::MatrixXf> rows);

/// The drilling: V_s = W_s H_s with the phases of X (section 2.3, with V_s where V_n is printed). Thread:
/// OFF.
Spectrogram paper_drilling(const Spectrogram& X, const PaperNmfOptions& options);

}  // namespace rigsound::analysis
