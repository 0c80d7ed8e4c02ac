// Short-time Fourier transform with a periodic Hann window, frames centred on multiples of the hop.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace rigsound::analysis {

struct StftShape {
  int window = 512;  ///< samples
  int hop = 128;     ///< samples
  int fft = 512;     ///< samples, at least `window`
  int bins() const { return fft / 2 + 1; }
};

constexpr StftShape kChainStft{512, 128, 512};
constexpr StftShape kPaperStft{1024, 128, 2048};  ///< drilling paper, section 2.3

/// bins x frames; one bin's course in time is contiguous.
using Spectrogram = Eigen::Array<std::complex<float>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Grid = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The periodic Hann window, `length` samples.
Eigen::ArrayXf hann(int length);

/// ceil(size/hop) frames; frame i covers `window` samples around sample i*hop, zeros outside `x`. Thread:
/// OFF.
Spectrogram stft(const std::vector<float>& x, const StftShape& shape);

/// Mean of |stft(x)|^2 over the frames, a bin. Thread: OFF.
Eigen::ArrayXd mean_power(const std::vector<float>& x, const StftShape& shape);

/// Least-squares inverse (overlap-add of windowed frames over the sum of squared windows), `length` samples.
/// Gives back x from stft(x) to rounding. Thread: OFF.
std::vector<float> inverse_stft(const Spectrogram& X, size_t length, const StftShape& shape);

}  // namespace rigsound::analysis
