#include "clicks/envelope.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {

double envelope(const ClickEnvelope& shape, double n) {
  const auto [N_a, alpha_a, alpha_d] = shape;
  if (n < 0) return 0;
  if (n > N_a) return std::exp(-(n - N_a) * alpha_d);
  if (std::fabs(alpha_a * N_a) < 1e-6) return n / N_a;
  return std::expm1(-alpha_a * n) / std::expm1(-alpha_a * N_a);
}

double rise_samples(const ClickEnvelope& shape) {
  const double bend = std::fabs(shape.attack_bend * shape.attack_samples);
  return bend < 1e-6 ? shape.attack_samples : shape.attack_samples * -std::expm1(-bend) / bend;
}

EnvelopePower envelope_power(const ClickEnvelope& shape, int block) {
  const int blocks = static_cast<int>(std::floor(shape.attack_samples)) / block + 1;
  EnvelopePower power;
  power.attack = Eigen::ArrayXd::Zero(blocks);
  for (int n = 0; n < blocks * block; ++n) {
    const double a = envelope(shape, n);
    power.attack(n / block) += a * a / block;
  }
  power.decay = std::exp(-2 * shape.decay * block);
  const double first = envelope(shape, blocks * block), step = std::exp(-2 * shape.decay);
  power.tail = first * first * (1 - power.decay) / (1 - step) / block;
  return power;
}

double envelope_energy(const ClickEnvelope& shape) {
  const EnvelopePower power = envelope_power(shape, 1);
  return power.attack.sum() + power.tail / (1 - power.decay);
}

}  // namespace rigsound::analysis
