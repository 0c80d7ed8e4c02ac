#include "background/hydraulic_voice.hpp"

#include "rigsound/dsp/linear_prediction.hpp"
#include "rigsound/limits.hpp"

namespace rigsound::background {
namespace {

constexpr double kUnit = 3.46410161513775;  // sqrt 12: a uniform number of unit variance
constexpr double kPumpLinewidth_hz = 0.3;   // strokes are not quite even
constexpr int kResponse = 1 << 13;          // samples in which 1/A dies away

std::vector<BackgroundOscillator> strokes(const HydraulicPart& part) {
  std::vector<BackgroundOscillator> tones;
  for (std::size_t h = 1; h <= part.pump.size(); ++h)
    tones.push_back({part.pump_order * static_cast<double>(h), true, static_cast<double>(part.pump[h - 1]),
                     kPumpLinewidth_hz});
  return tones;
}

std::vector<double> colour(const BackgroundModel& model, double sample_rate) {
  if (model.hydraulic.flow_A.empty()) return {1.0};
  return dsp::all_pole_at_rate({model.hydraulic.flow_A.begin(), model.hydraulic.flow_A.end()},
                               model.sample_rate, sample_rate);
}

/// What white noise of unit variance becomes behind 1/A.
double rms_of(const std::vector<double>& a) {
  std::vector<double> response(kResponse, 0.0);
  response[0] = 1;
  dsp::AllPole(a).process(response.data(), kResponse);
  double energy = 0;
  for (const double y : response) energy += y * y;
  return std::sqrt(energy);
}

}  // namespace

HydraulicVoice::HydraulicVoice(const BackgroundModel& model, double sample_rate, std::uint64_t seed)
    : exponent_(model.hydraulic.exponent),
      flow_(kUnit * model.hydraulic.flow / rms_of(colour(model, sample_rate))),
      pump_(strokes(model.hydraulic), sample_rate, seed, 44),
      colour_(colour(model, sample_rate)),
      random_(seed, 45) {}

void HydraulicVoice::add(double f, double feed, double running, double* out) noexcept {
  const double target = feed > 1e-4 ? running * dsp::pow(feed, exponent_) : 0.0;
  if (target == 0 && gain_ == 0) return;
  pump_.add(f, gain_, target, out);
  double flow[kChunk];
  for (double& v : flow) v = flow_ * (random_.uniform(sample_++, 0) - 0.5);
  colour_.process(flow, kChunk);
  for (int n = 0; n < kChunk; ++n) out[n] += (gain_ + (target - gain_) * (n + 1) / kChunk) * flow[n];
  gain_ = target;
}

}  // namespace rigsound::background
