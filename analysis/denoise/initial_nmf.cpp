#include "denoise/initial_nmf.hpp"

#include <random>

#include "denoise/word_fit.hpp"
#include "kernels/is_kernels.hpp"

namespace rigsound::analysis {
namespace {

constexpr float kActivationFloor = 1e-8f;

class Uniform {
 public:
  explicit Uniform(unsigned seed) : bits_(seed) {}
  float operator()() { return static_cast<float>(static_cast<double>(bits_() >> 11) * 0x1p-53); }

 private:
  std::mt19937_64 bits_;
};

Factors random_start(const PowerSpectrogram& power, const InitialNmfOptions& options) {
  Uniform uniform(options.seed);
  const int K_s = options.signal_words, words = K_s + options.noise_knots;
  Factors f;
  f.signal_words = K_s;
  f.H = Grid::Zero(words, power.padded());
  for (int k = 0; k < K_s; ++k)
    for (int n = 0; n < power.frames; ++n) f.H(k, n) = uniform() + 0.1f;
  f.H.bottomRows(options.noise_knots) = hats(options.noise_knots, power.frames, power.padded());
  const Eigen::ArrayXf noise = noise_level(power, options.noise_start);
  f.W = Grid(power.bins(), words);
  for (int m = 0; m < power.bins(); ++m) {
    const float mean = power.P.row(m).head(power.frames).mean(),
                rest = std::max(mean - noise(m), 0.1f * mean);
    for (int k = 0; k < K_s; ++k)
      f.W(m, k) = rest * (0.5f + uniform()) / static_cast<float>(K_s) / f.H.row(k).head(power.frames).mean();
    f.W.row(m).tail(options.noise_knots) = noise(m);
  }
  return f;
}

void update_activations(const PowerSpectrogram& power, float exponent, Factors& f) {
  const int K_s = f.signal_words;
  Grid numerator = Grid::Zero(K_s, power.padded()), denominator = numerator;
  const Activations H{f.H.data(), static_cast<int>(f.H.rows()), power.padded()};
  for (int m = 0; m < power.bins(); ++m)
    is_kernels().add_activation_terms(power.P.row(m).data(), H, f.W.row(m).data(), K_s, numerator.data(),
                                      denominator.data());
  auto learned = f.H.topLeftCorner(K_s, power.frames);
  learned *= (numerator / denominator).leftCols(power.frames).pow(exponent);
  learned = learned.max(kActivationFloor);
}

void normalise_words(Factors& f) {
  for (int k = 0; k < f.signal_words; ++k) {
    const float sum = f.W.col(k).sum();
    f.W.col(k) /= sum;
    f.H.row(k) *= sum;
  }
}

}  // namespace

Factors initial_nmf(const PowerSpectrogram& power, const InitialNmfOptions& options) {
  Factors f = random_start(power, options);
  const WordFit words(power);
  for (int i = 0; i < options.iterations; ++i) {
    update_activations(power, options.exponent, f);
    words.update({&options.exponent, 1, 1}, nullptr, f);
    normalise_words(f);
  }
  return f;
}

}  // namespace rigsound::analysis
