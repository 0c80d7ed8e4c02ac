#include "recording/clipping.hpp"

#include <cmath>

namespace rigsound::analysis {
namespace {

constexpr float kTop = 0.9999F;  // of the peak; a pure tone has 0.9 % of its samples there

}  // namespace

FlatTops::FlatTops(float peak) : level_(kTop * peak) {}

void FlatTops::add(const std::vector<float>& piece) {
  for (const float v : piece) {
    width_ = std::fabs(v) > level_ ? width_ + 1 : 0;
    if (width_ == 2) clipped_ += 2;  // the first is known to be on a top by the second
    if (width_ > 2) ++clipped_;
  }
  samples_ += piece.size();
}

double FlatTops::share() const {
  return samples_ == 0 ? 0 : static_cast<double>(clipped_) / static_cast<double>(samples_);
}

}  // namespace rigsound::analysis
