#include "recording/resample.hpp"

#include <samplerate.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rigsound::analysis {
namespace {

constexpr long kMostAtOnce = 1 << 14;  // samples of the output

SRC_STATE* new_state(int from, int to) {
  if (from == to) return nullptr;
  int error = 0;
  SRC_STATE* const state = src_new(SRC_SINC_BEST_QUALITY, 1, &error);
  if (!state) throw std::runtime_error(src_strerror(error));
  return state;
}

}  // namespace

std::size_t resampled_length(std::size_t frames, int from, int to) {
  const double ratio = static_cast<double>(to) / from;
  return static_cast<std::size_t>(std::lround(static_cast<double>(frames) * ratio));
}

Resampler::Resampler(int from, int to, std::size_t frames)
    : ratio_(static_cast<double>(to) / from),
      left_(resampled_length(frames, from, to)),
      state_(new_state(from, to), &src_delete) {}

Resampler::~Resampler() = default;

std::vector<float> Resampler::process(const std::vector<float>& piece) {
  return state_ ? converted(piece, 0) : piece;
}

std::vector<float> Resampler::finish() {
  if (!state_) return {};
  std::vector<float> rest = converted({}, 1);
  rest.resize(rest.size() + left_);  // libsamplerate may end a sample early
  return rest;
}

std::vector<float> Resampler::converted(const std::vector<float>& piece, int end_of_input) {
  std::vector<float> y;
  SRC_DATA job{};
  const float nothing = 0;
  job.data_in = piece.empty() ? &nothing : piece.data();  // without an address the end would not be flushed
  job.input_frames = static_cast<long>(piece.size());
  job.src_ratio = ratio_;
  job.end_of_input = end_of_input;
  while (left_ > 0) {
    const std::size_t before = y.size();
    job.output_frames = std::min(kMostAtOnce, static_cast<long>(left_));
    y.resize(before + static_cast<std::size_t>(job.output_frames));
    job.data_out = y.data() + before;
    if (const int error = src_process(state_.get(), &job)) throw std::runtime_error(src_strerror(error));
    y.resize(before + static_cast<std::size_t>(job.output_frames_gen));
    left_ -= static_cast<std::size_t>(job.output_frames_gen);
    job.data_in += job.input_frames_used;
    job.input_frames -= job.input_frames_used;
    if (job.output_frames_gen == 0 && job.input_frames_used == 0) break;
  }
  return y;
}

std::vector<float> resample(const std::vector<float>& x, int from, int to) {
  Resampler resampler(from, to, x.size());
  std::vector<float> y = resampler.process(x);
  const std::vector<float> rest = resampler.finish();
  y.insert(y.end(), rest.begin(), rest.end());
  return y;
}

}  // namespace rigsound::analysis
