#include "rigsound/engine.hpp"

#include <algorithm>
#include <stdexcept>

#include "background/background_layer.hpp"
#include "drill/drill_layer.hpp"
#include "engine_check.hpp"
#include "impact/impact_train.hpp"
#include "mix/mixer.hpp"
#include "scene/boom_scene.hpp"
#include "scene/rig_scene.hpp"
#include "scene/state_guard.hpp"
#include "tool/tool_layer.hpp"

namespace rigsound {
namespace {

/// One drill: its scene, its blows, and the two layers that hear them.
struct Boom {
  Boom(const EngineOptions& options, const SoundSet& sounds, int index)
      : scene(options, sounds), impacts(options.seed, index), drill(options.seed, index) {
    const int tool_index = options.booms[static_cast<std::size_t>(index)].tool;
    if (tool_index >= 0)
      tool.emplace_back(sounds.tools[static_cast<std::size_t>(tool_index)], options.sample_rate, options.seed,
                        index);
  }

  void process(double* drill_bus, double* tool_bus) noexcept {
    scene.advance();
    impacts.process(scene.statistics());
    drill.process(scene.slots(), scene.state().controls, impacts, drill_bus);
    if (tool.empty())
      std::fill(tool_bus, tool_bus + kChunk, 0.0);
    else
      tool.front().process(impacts.begin(), impacts.count(), tool_controls(), tool_bus);
  }

  tool::ToolControls tool_controls() const noexcept {
    tool::ToolControls controls;
    if (scene.statistics().T_0 > 0) controls.period = scene.statistics().T_0;
    controls.rods = scene.state().rod_count;
    return controls;
  }

  scene::BoomScene scene;
  impact::ImpactTrain impacts;
  drill::DrillLayer drill;
  std::vector<tool::ToolLayer> tool;  ///< none or one
};

}  // namespace

struct Engine::Rooms {
  Rooms(const EngineOptions& o, SoundSet s)
      : options(o),
        sounds(std::move(s)),
        rig(options),
        background(sounds.backgrounds, options.sample_rate, options.seed, options.scene.idle_rpm),
        mixer(options) {
    for (int b = 0; b < static_cast<int>(options.booms.size()); ++b) booms.emplace_back(options, sounds, b);
  }

  void latch(const MachineState& state) noexcept;
  void measure(const float* out) noexcept;

  EngineOptions options;
  SoundSet sounds;
  scene::RigScene rig;
  std::vector<Boom> booms;
  background::BackgroundLayer background;
  mix::Mixer mixer;
  mix::Buses buses{};
  EngineMeters meters;
};

void Engine::Rooms::latch(const MachineState& state) noexcept {
  const MachineState safe = scene::guarded(state);
  int hammering = 0;
  for (std::size_t b = 0; b < booms.size(); ++b) {
    booms[b].scene.latch(safe.boom[b]);
    hammering += booms[b].scene.hammering() ? 1 : 0;
  }
  rig.latch(safe, static_cast<int>(booms.size()), hammering);
}

void Engine::Rooms::measure(const float* out) noexcept {
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
  rooms_ = std::make_unique<Rooms>(options, std::move(sounds));
}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

void Engine::process(const MachineState& state, float* out) noexcept {
  Rooms& r = *rooms_;
  r.latch(state);
  r.meters.limiter_gain = 1;
  float* chunk = out;
  for (int n = 0; n < r.options.block; n += kChunk) {
    for (std::size_t b = 0; b < r.booms.size(); ++b) r.booms[b].process(r.buses.drill[b], r.buses.tool[b]);
    r.rig.advance();
    r.background.process(r.rig.background(), r.buses.background);
    r.mixer.process(r.buses, r.rig.gain_from(), r.rig.gain_to(), chunk);
    r.meters.limiter_gain = std::min(r.meters.limiter_gain, static_cast<float>(r.mixer.lowest_gain()));
    chunk += kChunk * r.options.channels;
  }
  r.measure(out);
}

EngineMeters Engine::meters() const noexcept { return rooms_->meters; }
const EngineOptions& Engine::options() const noexcept { return rooms_->options; }

}  // namespace rigsound
