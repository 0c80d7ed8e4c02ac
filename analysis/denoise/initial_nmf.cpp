#include "denoise/initial_nmf.hpp"

#include <random>

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

Factors random_start(const WordFit& clip, const InitialNmfOptions& options) {
  const PowerSpectrogram& power = clip.power();
  Uniform uniform(options.seed);
  const int K_s = options.signal_words, words = K_s + options.noise_knots;
  Factors f;
  f.signal_words = K_s;
  f.H = Grid::Zero(words, power.padded());
  for (int k = 0; k < K_s; ++k)
    for (int n = 0; n < power.frames; ++n) f.H(k, n) = uniform() + 0.1f;
  f.H.bottomRows(options.noise_knots) = hats(options.noise_knots, power.frames, power.padded());
  const Eigen::ArrayXf noise = clip.noise(options.noise_start);
  f.W = Grid(power.bins(), words);
  for (int m = 0; m < power.bins(); ++m) {
    const float mean = clip.mean()(m), rest = std::max(mean - noise(m), 0.1f * mean);
    for (int k = 0; k < K_s; ++k)
      f.W(m, k) = rest * (0.5f + uniform()) / static_cast<float>(K_s) / f.H.row(k).head(power.frames).mean();
    f.W.row(m).tail(options.noise_knots) = noise(m);
  }
  return f;
}

void update_activations(const PowerSpectrogram& power, float exponent, Factors& f) {
  const int K_s = f.signal_words;
  Grid numerator(K_s, power.padded()), denominator(K_s, power.padded());
  const Activations H{f.H.data(), static_cast<int>(f.H.rows()), power.padded()};
  is_kernels().sum_over_bins({power.P.data(), f.W.data(), power.bins()}, H, K_s, numerator.data(),
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

Factors initial_nmf(const WordFit& clip, const InitialNmfOptions& options) {
  Factors f = random_start(clip, options);
  for (int i = 0; i < options.iterations; ++i) {
    update_activations(clip.power(), options.exponent, f);
    clip.update({&options.exponent, 1, 1}, nullptr, f);
    normalise_words(f);
  }
  return f;
}

}  // namespace rigsound::analysis
