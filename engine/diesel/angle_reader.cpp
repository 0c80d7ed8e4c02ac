#include "diesel/angle_reader.hpp"

#include "rigsound/dsp/interpolation_kernel.hpp"

namespace rigsound::diesel {
namespace {

constexpr double kBeta = 8;

}  // namespace

AngleReader::AngleReader() {
  const dsp::InterpolationKernel kernel(kTaps, kRows, kBeta);
  std::vector<double> row(kTaps);
  for (int i = 0; i <= kRows; ++i) {
    // The last row is the first one, a sample on.
    kernel.weights(i < kRows ? static_cast<double>(i) / kRows : 0.0, row.data());
    if (i == kRows) row.insert(row.begin(), 0.0), row.pop_back();
    rows_.insert(rows_.end(), row.begin(), row.end());
  }
}

}  // namespace rigsound::diesel
