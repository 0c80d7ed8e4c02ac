#include "tool/tool_layer.hpp"

#include <algorithm>
#include <stdexcept>

#include "dsp/elementary.hpp"

namespace rigsound::tool {
namespace {

constexpr double kLongitudinalSpeed = 5200;  // m/s in steel
constexpr double kPulse_s = 10 / 44100.0;    // erratum 11 of waveguide.md
constexpr double kLambda = -0.618;           // the paper's allpass coefficient
constexpr double kDcPole = 0.995;
constexpr double kLevel = 0.2;

std::vector<double> delay_of(double seconds, double sample_rate) {
  return std::vector<double>(static_cast<std::size_t>(std::max(2.0, std::floor(seconds * sample_rate + 0.5))),
                             0.0);
}

}  // namespace

ToolLayer::ToolLayer(const ToolModel& model, double sample_rate) : pulse_samples_(kPulse_s * sample_rate) {
  if (!(model.length_m > 0) || !(model.diameter_m > 0) || model.diameter_m > model.length_m)
    throw std::invalid_argument("tool \"" + model.name +
                                "\": length and diameter must be positive, diameter below length");
  const double round_trip_s = 2 * model.length_m / kLongitudinalSpeed;
  longitudinal_.delay = delay_of(round_trip_s, sample_rate);
  longitudinal_.reflection = model.k_L;
  transversal_.delay = delay_of(round_trip_s * 4, sample_rate);
  transversal_.reflection = (model.k_Tmin + model.k_Tmax) / 2;
  age_.fill(1e9);
  const double t = std::sqrt(3.0) * dsp::tan(dsp::kPi * 800 / sample_rate);
  high_pole_ = (1 - t) / (1 + t);
}

double ToolLayer::Loop::process(double x) noexcept {
  double v = delay[at];
  const double blocked = (1 + kDcPole) / 2 * (v - dc_in) + kDcPole * dc_out;
  dc_in = v;
  dc_out = v = blocked;
  for (double& s : allpass) {
    const double u = v - kLambda * s;
    v = kLambda * u + s;
    s = u;
  }
  const double y = x + reflection * v;
  delay[at] = y;
  at = at + 1 < delay.size() ? at + 1 : 0;
  return y;
}

void ToolLayer::process(const Impact* impacts, int count, double* out) noexcept {
  for (int i = 0; i < count; ++i) {
    age_[next_] = -impacts[i].onset;
    strength_[next_] = impacts[i].amplitude;
    next_ = (next_ + 1) % age_.size();
  }
  for (int n = 0; n < kChunk; ++n) {
    double x = 0;
    for (std::size_t i = 0; i < age_.size(); ++i) {
      if (age_[i] >= 0 && age_[i] < pulse_samples_)
        x += strength_[i] / 2 * (1 - dsp::cos(dsp::kTwoPi * age_[i] / pulse_samples_));
      age_[i] += 1;
    }
    const double bar = 0.5 * longitudinal_.process(x) + 0.5 * transversal_.process(x);
    high_out_ = (1 + high_pole_) / 2 * (bar - high_in_) + high_pole_ * high_out_;
    high_in_ = bar;
    out[n] = kLevel * high_out_;
  }
}

}  // namespace rigsound::tool
