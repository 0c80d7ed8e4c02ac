#include "diesel/hydraulic_voice.hpp"

#include "rigsound/dsp/energy.hpp"
#include "rigsound/dsp/linear_prediction.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::diesel {
namespace {

constexpr double kPumpLinewidth_hz = 0.3;  // strokes are not quite even
constexpr int kResponse = 1 << 13;         // samples in which 1/A dies away

std::vector<DieselOscillator> strokes(const HydraulicPart& part) {
  std::vector<DieselOscillator> tones;
  for (std::size_t h = 1; h <= part.pump.size(); ++h)
    tones.push_back({part.pump_order * static_cast<double>(h), true, static_cast<double>(part.pump[h - 1]),
                     kPumpLinewidth_hz});
  return tones;
}

std::vector<double> colour(const DieselModel& model, double sample_rate) {
  if (model.hydraulic.flow_filter.empty()) return {1.0};
  return dsp::all_pole_at_rate({model.hydraulic.flow_filter.begin(), model.hydraulic.flow_filter.end()},
                               model.sample_rate, sample_rate);
}

/// What white noise of unit variance becomes behind 1/A.
double rms_of(const std::vector<double>& a) {
  std::vector<float> response(kResponse, 0.0F);
  response[0] = 1;
  dsp::AllPole(a).process(response.data(), kResponse);
  return std::sqrt(dsp::energy(response));
}

}  // namespace

HydraulicVoice::HydraulicVoice(const DieselModel& model, double sample_rate, std::uint64_t seed)
    : exponent_(model.hydraulic.exponent),
      flow_(model.hydraulic.flow / rms_of(colour(model, sample_rate))),
      pump_(strokes(model.hydraulic), sample_rate, seed, 44),
      colour_(colour(model, sample_rate)),
      random_(seed, 45) {}

void HydraulicVoice::add(double f, double feed, double running, double* out) noexcept {
  gain_.go_to(feed > 1e-4 ? running * dsp::pow(feed, exponent_) : 0.0);
  if (gain_.rests_at(0)) return;
  pump_.add(f, gain_, out);
  float flow[kChunk];
  for (float& v : flow) v = static_cast<float>(flow_ * random_.white(sample_++, 0));
  colour_.process(flow, kChunk);
  dsp::add_scaled(gain_, flow, out, kChunk);
}

}  // namespace rigsound::diesel
