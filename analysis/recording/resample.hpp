// Change of sample rate (libsamplerate's best sinc).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

struct SRC_STATE_tag;

namespace rigsound::analysis {

/// Samples of `frames` at `from` Hz when they are brought to `to` Hz: rounded. Thread: OFF.
std::size_t resampled_length(std::size_t frames, int from, int to);

/// A signal at `from` Hz, piece by piece, as one at `to` Hz, time origin kept. Thread: OFF.
class Resampler {
 public:
  /// `frames`: of the whole input. Errors: std::runtime_error when libsamplerate refuses the ratio.
  Resampler(int from, int to, std::size_t frames);
  ~Resampler();

  std::vector<float> process(const std::vector<float>& piece);
  std::vector<float> finish();  ///< what is left when the last piece has come

 private:
  std::vector<float> converted(const std::vector<float>& piece, int end_of_input);

  double ratio_;
  std::size_t left_;  ///< samples of the output that are still to come
  std::unique_ptr<SRC_STATE_tag, SRC_STATE_tag* (*)(SRC_STATE_tag*)> state_;
};

/// `x` at `from` Hz as a whole. Thread: OFF.
std::vector<float> resample(const std::vector<float>& x, int from, int to);

}  // namespace rigsound::analysis
