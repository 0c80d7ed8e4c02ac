#include "bank/band_shares.hpp"

#include <cmath>

#include "rigsound/dsp/energy.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kTransform = 8192;
constexpr double kLowestBin = 8;  // of kTransform

}  // namespace

BandShares::BandShares() : pair_(kTransform) {
  const double octaves = std::log(0.5 * kTransform / kLowestBin);
  for (int b = 0; b <= kBands; ++b)
    edges_.push_back(static_cast<int>(kLowestBin * std::exp(octaves * b / kBands) + 1e-9));
}

std::array<BandShares::Shares, 2> BandShares::operator()(const std::vector<float>& first,
                                                         const std::vector<float>& second) {
  pair_.set(first, second);
  pair_.forward();
  std::array<Shares, 2> shares{Shares::Zero(), Shares::Zero()};
  for (int b = 0; b < kBands; ++b)
    for (int k = edges_[b]; k < edges_[b + 1]; ++k) {
      shares[0](b) += static_cast<double>(std::norm(pair_.first_bin(k)));
      shares[1](b) += static_cast<double>(std::norm(pair_.second_bin(k)));
    }
  shares[0] /= dsp::energy(first);
  if (!second.empty()) shares[1] /= dsp::energy(second);
  return shares;
}

}  // namespace rigsound::analysis
