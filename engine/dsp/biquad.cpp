#include "rigsound/dsp/biquad.hpp"

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

BiquadCoefficients peaking(double frequency_hz, double gain_db, double q, double sample_rate) {
  const double A = gain_of_db(gain_db / 2);
  const double w = kTwoPi * frequency_hz / sample_rate;
  const double alpha = sin(w) / (2 * q);
  const double a0 = 1 + alpha / A;
  const double shared = -2 * cos(w) / a0;
  return {(1 + alpha * A) / a0, shared, (1 - alpha * A) / a0, shared, (1 - alpha / A) / a0};
}

}  // namespace rigsound::dsp
