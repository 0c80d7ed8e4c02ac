#include "rigsound/engine.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "diesel/diesel_layer.hpp"
#include "drill/drill_layer.hpp"
#include "engine_check.hpp"
#include "impact/impact_train.hpp"
#include "impact/rate_counter.hpp"
#include "mix/layer_meter.hpp"
#include "mix/mixer.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/machine/state_guard.hpp"
#include "scene/boom_scene.hpp"
#include "scene/rig_scene.hpp"
#include "string/string_layer.hpp"
#include "tool/tool_layer.hpp"

namespace rigsound {
namespace {

/// One drill: its scene, its impacts, and the layers that hear them.
struct Boom {
  Boom(const EngineOptions& options, const scene::ClickSpectra& spectra, int index)
      : scene(options, spectra, index),
        train(options.seed, index),
        drill(options.seed, index, options.sample_rate),
        drill_gain(dsp::gain_of_db(options.mix.drill_db + options.booms[index].gain_db)),
        tool_gain(dsp::gain_of_db(options.mix.tool_db + options.booms[index].gain_db)),
        made(options.sample_rate) {
    const BoomOptions& boom = options.booms[index];
    const SoundSet& sounds = spectra.sounds();
    if (boom.tool >= 0) tool.emplace(sounds.tools[boom.tool], options.sample_rate, options.seed, index);
    if (boom.drill_string >= 0)
      rods.emplace(sounds.strings[boom.drill_string], options.sample_rate, options.seed, index);
  }

  void process(mix::Bus& drill_bus, mix::Bus& tool_bus) noexcept {
    scene.advance();
    train.process(scene.impacts());
    drill_bus.sounds = drill.process(scene.drill(), train.impacts(), drill_bus.x);
    drill_meter.admit(drill, drill_bus);
    if (tool) {
      tool_bus.sounds = tool->process(scene.tool(), train.impacts(), tool_bus.x);
      tool_meter.admit(*tool, tool_bus);
    }
    if (rods) {
      tool_bus.sounds = rods->process(scene.rods(), train.impacts(), tool_bus.x);
      tool_meter.admit(*rods, tool_bus);
    }
    made.add(train.impacts().count);
  }

  std::uint64_t take_dropped() noexcept { return drill_meter.take_dropped() + tool_meter.take_dropped(); }

  /// Of a block of `frames`.
  void describe(int frames, BoomView& view) noexcept {
    scene.describe(view);
    view.impacts_made_hz = static_cast<float>(made.rate_hz());
    view.drill = drill_meter.take(drill_gain, frames);
    view.tool = tool_meter.take(tool_gain, frames);
  }

  scene::BoomScene scene;
  impact::ImpactTrain train;
  drill::DrillLayer drill;
  std::optional<tool::ToolLayer> tool;      ///< a bar,
  std::optional<string::StringLayer> rods;  ///< or a drill string

  double drill_gain, tool_gain;
  impact::RateCounter made;
  mix::LayerMeter drill_meter, tool_meter;
};

/// Everything that changes while the engine plays; copied to begin anew. No copy of a copy allocates.
struct Playing {
  Playing(const EngineOptions& options, const SoundSet& sounds)
      : rig(options),
        diesel(sounds.diesels, options.sample_rate, options.seed, options.scene.idle_rpm),
        mixer(options),
        diesel_gain(dsp::gain_of_db(options.mix.diesel_db)) {
    const scene::ClickSpectra spectra(sounds);
    for (int b = 0; b < static_cast<int>(options.booms.size()); ++b) booms.emplace_back(options, spectra, b);
  }

  void set(const MachineState& state) noexcept;
  std::uint64_t take_dropped() noexcept;

  scene::RigScene rig;
  std::vector<Boom> booms;
  diesel::DieselLayer diesel;
  mix::Mixer mixer;

  double diesel_gain;
  mix::LayerMeter diesel_meter;
};

void Playing::set(const MachineState& state) noexcept {
  int hammering = 0;
  for (std::size_t b = 0; b < booms.size(); ++b) {
    booms[b].scene.set(state.boom[b]);
    hammering += booms[b].scene.hammering() ? 1 : 0;
  }
  rig.set(state, static_cast<int>(booms.size()), hammering);
}

std::uint64_t Playing::take_dropped() noexcept {
  std::uint64_t dropped = diesel_meter.take_dropped() + mixer.take_dropped();
  for (Boom& boom : booms) dropped += boom.take_dropped();
  return dropped;
}

}  // namespace

struct Engine::Parts {
  Parts(const EngineOptions& o, SoundSet s)
      : options(o),
        lookahead(lookahead_frames(o)),
        sounds(std::move(s)),
        fresh(options, sounds),
        playing(fresh) {}

  void set(const MachineState& state) noexcept;
  void process_chunk(float* out) noexcept;
  void measure() noexcept;
  void describe() noexcept;

  EngineOptions options;
  int lookahead;  ///< frames
  SoundSet sounds;
  const Playing fresh;  ///< as it was built
  Playing playing;
  MachineState state;  ///< as last told
  bool told = false, begun = false;
  int still_frames =
      0;  ///< since the rig fell silent for a pause, counted while the limiter still holds sound
  mix::Buses buses{};
  EngineMeters meters;
  EngineView view;
};

void Engine::Parts::set(const MachineState& next) noexcept {
  if (told && next == state) return;
  told = true;
  state = next;
  playing.set(guarded(state));
}

/// While the simulator is paused time stands still, once the sound has faded and left the limiter; after
/// `reset` it begins anew.
void Engine::Parts::process_chunk(float* out) noexcept {
  Playing& p = playing;
  still_frames = p.rig.stands_still() ? std::min(still_frames, lookahead) + kChunk : 0;
  if (still_frames > lookahead) {
    if (begun && state.simulation == Simulation::kReset) {
      playing = fresh;
      playing.set(guarded(state));
      begun = false;
    }
    std::fill(out, out + kChunk * options.channels, 0.0F);
    return;
  }
  begun = true;
  for (std::size_t b = 0; b < p.booms.size(); ++b) p.booms[b].process(buses.drill[b], buses.tool[b]);
  p.rig.advance();
  buses.diesel.sounds = p.diesel.process(p.rig.diesel(), buses.diesel.x);
  p.diesel_meter.admit(p.diesel, buses.diesel);
  p.mixer.process(buses, p.rig.gain(), out);
  meters.limiter_gain = std::min(meters.limiter_gain, static_cast<float>(p.mixer.lowest_gain()));
}

void Engine::Parts::measure() noexcept {
  const LayerLevel level = playing.mixer.take_level(options.block * options.channels);
  meters.peak = level.peak;
  meters.rms = level.rms;
  meters.dropped_chunks += playing.take_dropped();
  meters.lost_clicks = 0;
  for (const Boom& boom : playing.booms) meters.lost_clicks += boom.drill.lost();
}

void Engine::Parts::describe() noexcept {
  for (std::size_t b = 0; b < playing.booms.size(); ++b)
    playing.booms[b].describe(options.block, view.boom[b]);
  view.diesel = playing.diesel_meter.take(playing.diesel_gain, options.block);
  view.stands_still = playing.rig.stands_still();
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
  p.set(state);
  p.meters.limiter_gain = 1;
  for (int n = 0; n < p.options.block; n += kChunk) p.process_chunk(out + n * p.options.channels);
  p.measure();
  p.describe();
}

EngineMeters Engine::meters() const noexcept { return parts_->meters; }
const EngineView& Engine::view() const noexcept { return parts_->view; }
const EngineOptions& Engine::options() const noexcept { return parts_->options; }

}  // namespace rigsound
