#include "recording/resample.hpp"

#include <samplerate.h>

#include <cmath>
#include <stdexcept>

namespace rigsound::analysis {

std::vector<float> resample(const std::vector<float>& x, int from, int to) {
  if (from == to) return x;
  const double ratio = static_cast<double>(to) / from;
  std::vector<float> y(static_cast<size_t>(std::lround(static_cast<double>(x.size()) * ratio)));
  SRC_DATA job{};
  job.data_in = x.data();
  job.data_out = y.data();
  job.input_frames = static_cast<long>(x.size());
  job.output_frames = static_cast<long>(y.size());
  job.src_ratio = ratio;
  if (const int error = src_simple(&job, SRC_SINC_BEST_QUALITY, 1))
    throw std::runtime_error(src_strerror(error));
  return y;
}

}  // namespace rigsound::analysis
