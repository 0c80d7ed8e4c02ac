#include "bank/band_shares.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/energy.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kTransform = 8192;
constexpr double kLowestBin = 8;  // of kTransform

}  // namespace

BandShares::BandShares() : frame_(kTransform) {
  fft_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  const double octaves = std::log(0.5 * kTransform / kLowestBin);
  for (int b = 0; b <= kBands; ++b)
    edges_.push_back(static_cast<int>(kLowestBin * std::exp(octaves * b / kBands) + 1e-9));
}

BandShares::Shares BandShares::operator()(const std::vector<float>& click) {
  frame_.setZero();
  const long length = std::min<long>(kTransform, static_cast<long>(click.size()));
  frame_.head(length) = Eigen::Map<const Eigen::VectorXf>(click.data(), length).cast<double>();
  fft_.fwd(bins_, frame_);
  const Eigen::ArrayXd power = bins_.array().abs2();
  const double energy = dsp::energy(click);
  Shares shares;
  for (int b = 0; b < kBands; ++b)
    shares(b) = power.segment(edges_[b], edges_[b + 1] - edges_[b]).sum() / energy;
  return shares;
}

}  // namespace rigsound::analysis
