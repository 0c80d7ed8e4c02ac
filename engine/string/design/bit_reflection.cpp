#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/string_model.hpp"
#include "string/bit_contact.hpp"
#include "string/design/string_tuning.hpp"

namespace rigsound {

double loading_time_s(const StringModel& model, double stiffness_n_per_m) {
  return string::rod_impedance(model) / stiffness_n_per_m;
}

double reflected_energy(double x) { return 1 - 4 * (1 - dsp::exp(-x)) / x + 2 * (1 - dsp::exp(-2 * x)) / x; }

BitReflection played_reflection(const std::vector<double>& pulse, double loading_samples) {
  string::BitContact bit;
  bit.set_loading(loading_samples);
  BitReflection reflection;
  double sent = 0, back = 0, largest = 0;
  // One chunk more than the pulse: what the rock still holds when it ends goes back in one sample.
  for (std::size_t at = 0; at < pulse.size() + kChunk; at += kChunk) {
    double down[kChunk], up[kChunk];
    for (std::size_t n = 0; n < kChunk; ++n) down[n] = at + n < pulse.size() ? pulse[at + n] : 0;
    bit.process(down, up, kChunk);
    for (int n = 0; n < kChunk; ++n) {
      sent += down[n] * down[n], back += up[n] * up[n];
      largest = std::max(largest, std::fabs(down[n]));
      reflection.force = std::max(reflection.force, down[n] + up[n]);
    }
  }
  reflection.energy = back / sent;
  reflection.force /= largest;
  return reflection;
}

}  // namespace rigsound
