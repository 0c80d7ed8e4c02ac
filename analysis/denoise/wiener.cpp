#include "denoise/wiener.hpp"

namespace rigsound::analysis {

Spectrogram wiener(const Spectrogram& X, const PsdPair& psd) {
  const Grid gain = psd.S / (psd.S + psd.N).max(1e-30f);
  return X * gain.cast<std::complex<float>>();
}

}  // namespace rigsound::analysis
