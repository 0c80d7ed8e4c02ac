#include "bank/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "bank/click_masks.hpp"
#include "clicks/gaps.hpp"
#include "rigsound/dsp/energy.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kTransform = 8192;
constexpr double kLowestBin = 8;      // of kTransform
constexpr double kWholeEnough = 0.6;  // of the click length before the end of the signal

/// Energies of a click in log-spaced bands, as shares of the whole.
class BandShares {
 public:
  BandShares() : frame_(kTransform) {
    fft_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    const double octaves = std::log(0.5 * kTransform / kLowestBin);
    for (int b = 0; b <= kCoverBands; ++b)
      edges_.push_back(static_cast<int>(kLowestBin * std::exp(octaves * b / kCoverBands) + 1e-9));
  }

  Eigen::ArrayXd operator()(const std::vector<float>& click, double energy) {
    frame_.setZero();
    const long length = std::min<long>(kTransform, static_cast<long>(click.size()));
    frame_.head(length) = Eigen::Map<const Eigen::VectorXf>(click.data(), length).cast<double>();
    fft_.fwd(bins_, frame_);
    const Eigen::ArrayXd power = bins_.array().abs2();
    Eigen::ArrayXd shares(kCoverBands);
    for (int b = 0; b < kCoverBands; ++b)
      shares(b) = power.segment(edges_[b], edges_[b + 1] - edges_[b]).sum() / energy;
    return shares;
  }

 private:
  Eigen::FFT<double> fft_;
  Eigen::VectorXd frame_;
  Eigen::VectorXcd bins_;
  std::vector<int> edges_;
};

}  // namespace

std::vector<ClickCandidate> click_candidates(const Segments& segments) {
  std::vector<ClickCandidate> candidates;
  BandShares band_shares;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto& [P, beta, shape, T_0] = segments[s].result.clicks;
    const std::vector<float>& x = segments[s].result.drilling;
    const ClickMasks masks(segments[s].result.clicks, static_cast<long>(x.size()));
    const double period = median_gap(P);
    const std::size_t first = std::max<std::size_t>(segments[s].first, 1);
    for (std::size_t i = first; i < segments[s].last && i + 1 < P.size(); ++i) {
      if (P[i] + kWholeEnough * masks.click_length() >= static_cast<double>(x.size())) continue;
      const std::vector<float> click = masks.extract(x, i);
      const double energy = dsp::energy(click);
      if (energy <= 0) continue;
      const double louder = std::max(beta[i - 1], beta[i + 1]);
      candidates.push_back({s, i, std::sqrt(energy), (P[i + 1] - P[i]) / period,
                            beta[i] / std::max(louder, 1e-9), band_shares(click, energy)});
    }
  }
  return candidates;
}

}  // namespace rigsound::analysis
