#include "rigsound/engine.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "diesel/diesel_layer.hpp"
#include "drill/drill_layer.hpp"
#include "engine_check.hpp"
#include "impact/impact_train.hpp"
#include "mix/mixer.hpp"
#include "rigsound/machine/state_guard.hpp"
#include "scene/boom_scene.hpp"
#include "scene/rig_scene.hpp"
#include "tool/tool_layer.hpp"

namespace rigsound {
namespace {

/// One drill: its scene, its impacts, and the two layers that hear them.
struct Boom {
  Boom(const EngineOptions& options, const SoundSet& sounds, int index)
      : scene(options, sounds), train(options.seed, index), drill(options.seed, index) {
    const int tool_index = options.booms[index].tool;
    if (tool_index >= 0) tool.emplace(sounds.tools[tool_index], options.sample_rate, options.seed, index);
  }

  void process(double* drill_bus, double* tool_bus) noexcept {
    scene.advance();
    train.process(scene.impacts());
    drill.process(scene.drill(), train.impacts(), drill_bus);
    if (tool)
      tool->process(scene.tool(), train.impacts(), tool_bus);
    else
      std::fill(tool_bus, tool_bus + kChunk, 0.0);
  }

  scene::BoomScene scene;
  impact::ImpactTrain train;
  drill::DrillLayer drill;
  std::optional<tool::ToolLayer> tool;
};

}  // namespace

struct Engine::Parts {
  Parts(const EngineOptions& o, SoundSet s)
      : options(o),
        sounds(std::move(s)),
        rig(options),
        diesel(sounds.diesels, options.sample_rate, options.seed, options.scene.idle_rpm),
        mixer(options) {
    for (int b = 0; b < static_cast<int>(options.booms.size()); ++b) booms.emplace_back(options, sounds, b);
  }

  void latch(const MachineState& state) noexcept;
  void measure(const float* out) noexcept;

  EngineOptions options;
  SoundSet sounds;
  scene::RigScene rig;
  std::vector<Boom> booms;
  diesel::DieselLayer diesel;
  mix::Mixer mixer;
  mix::Buses buses{};
  EngineMeters meters;
};

void Engine::Parts::latch(const MachineState& state) noexcept {
  const MachineState safe = guarded(state);
  int hammering = 0;
  for (std::size_t b = 0; b < booms.size(); ++b) {
    booms[b].scene.latch(safe.boom[b]);
    hammering += booms[b].scene.hammering() ? 1 : 0;
  }
  rig.latch(safe, static_cast<int>(booms.size()), hammering);
}

void Engine::Parts::measure(const float* out) noexcept {
  const int samples = options.block * options.channels;
  float peak = 0;
  double energy = 0;
  for (int n = 0; n < samples; ++n) {
    peak = std::max(peak, std::fabs(out[n]));
    energy += static_cast<double>(out[n]) * static_cast<double>(out[n]);
  }
  meters.peak = peak;
  meters.rms = static_cast<float>(std::sqrt(energy / samples));
  meters.lost_clicks = 0;
  for (const Boom& boom : booms) meters.lost_clicks += boom.drill.lost();
}

Engine::Engine(const EngineOptions& options, SoundSet sounds) {
  require_valid(options, sounds);
  parts_ = std::make_unique<Parts>(options, std::move(sounds));
}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

void Engine::process(const MachineState& state, float* out) noexcept {
  Parts& p = *parts_;
  p.latch(state);
  p.meters.limiter_gain = 1;
  float* chunk = out;
  for (int n = 0; n < p.options.block; n += kChunk) {
    for (std::size_t b = 0; b < p.booms.size(); ++b) p.booms[b].process(p.buses.drill[b], p.buses.tool[b]);
    p.rig.advance();
    p.diesel.process(p.rig.diesel(), p.buses.diesel);
    p.mixer.process(p.buses, p.rig.gain(), chunk);
    p.meters.limiter_gain = std::min(p.meters.limiter_gain, static_cast<float>(p.mixer.lowest_gain()));
    chunk += kChunk * p.options.channels;
  }
  p.measure(out);
}

EngineMeters Engine::meters() const noexcept { return parts_->meters; }
const EngineOptions& Engine::options() const noexcept { return parts_->options; }

}  // namespace rigsound
