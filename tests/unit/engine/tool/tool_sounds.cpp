#include "engine/tool/tool_sounds.hpp"

#include <algorithm>

namespace rigsound::tests {

using namespace tool;

ToolModel model_of(const Bar& bar) {
  ToolModel model;
  model.bar = bar;
  return model;
}

ToolModel plain_model(const Bar& bar) {
  ToolModel model = model_of(bar);
  model.strike.amplitude_variation = 0;
  model.strike.bounces = 0;
  model.strike.slope_variation = 0;
  return model;
}

ToolModel long_ringing_model() {
  ToolModel model = plain_model();
  model.strike.width_s = 0.001;
  model.transversal.reflection_min = 0.998, model.transversal.reflection_max = 0.999;
  model.longitudinal.reflection_min = model.longitudinal.reflection_max = 0.999;
  model.rods = {{2, {model.bar.length_m + 0.05, model.bar.diameter_m}}};
  return model;
}

Curves::Curves(double T, double L) {
  std::fill(k_T, k_T + kChunk, T);
  std::fill(k_L, k_L + kChunk, L);
  std::fill(mix, mix + kChunk, 0.5);
}

BarDrive Curves::drive(int frames) const {
  const bool struck = std::any_of(x, x + frames, [](double sample) { return sample != 0; });
  return {frames, struck, x, {k_T, k_L}, {mix, mix}};
}

std::vector<double> impulse_response(const ToolDesign& design, Family family, double k, int samples,
                                     dsp::LaneWidth width) {
  BarLoops bar(design, 800, width);
  Curves curves(k, k);
  std::vector<double> y;
  double out[kChunk];
  for (int n = 0; n < samples; n += kChunk) {
    for (int i = 0; i < kChunk; ++i) curves.x[i] = n + i == 0;
    bar.process(curves.drive(), out);
    for (int i = kChunk; i > 0; --i) y.push_back(bar.state().line[bar.state().at - i][family]);
  }
  return y;
}

std::vector<double> struck(ToolLayer& layer, const Blows& blows,
                           const std::function<ToolInput(double)>& controls) {
  std::vector<double> sound;
  double next = blows.first_s * blows.rate;
  std::uint64_t index = 0;
  for (double start = 0; start < blows.seconds * blows.rate; start += kChunk) {
    Impact blow;
    int count = 0;
    if (next < start + kChunk)
      blow = {next - start, 1, index++}, count = 1, next += blows.period_s * blows.rate;
    double out[kChunk];
    ToolInput c = controls(start / blows.rate);
    c.period = blows.period_s * blows.rate;
    layer.process(c, {&blow, count}, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  return sound;
}

std::vector<double> one_blow(const ToolModel& model, double rate) {
  ToolLayer layer(model, rate, 1, 0);
  Blows blows;
  blows.rate = rate;
  return struck(layer, blows, [](double) { return ToolInput{}; });
}

}  // namespace rigsound::tests
