// rigsound timeline: the picture of a render.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "endings.hpp"
#include "progress_bar.hpp"
#include "rigsound/analysis/timeline.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/machine/signal.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct TimelineArguments {
  std::string picture, sound, states, rig;
  double underfeed_bar = SceneOptions().underfeed_bar, overfeed_bar = SceneOptions().overfeed_bar;
  std::optional<cli::Option> underfeed, overfeed;
  analysis::TimelineOptions timeline;
};

void draw(TimelineArguments o) {
  require_ending("OUT.png", o.picture, {".png"});
  SceneOptions& scene = o.timeline.scene;
  if (!o.rig.empty()) scene = config::load_rig(o.rig, config::Buses::kLeftOut).engine.scene;
  if (o.underfeed->given()) scene.underfeed_bar = o.underfeed_bar;
  if (o.overfeed->given()) scene.overfeed_bar = o.overfeed_bar;
  if (scene.underfeed_bar >= scene.overfeed_bar)
    throw cli::UsageError("--underfeed",
                          fmt::format("is {:g} bar, expected less than the {:g} bar of overfeed",
                                      scene.underfeed_bar, scene.overfeed_bar));
  ProgressBar bar;
  analysis::write_timeline(o.picture, o.sound, o.states, o.timeline,
                           [&bar](double share) { bar.show(share); });
}

}  // namespace

void add_timeline(cli::Verb& program) {
  cli::Verb verb = program.verb("timeline", "Draw a render: states, waveform, spectrogram").group(kInspect);
  auto o = std::make_shared<TimelineArguments>();
  verb.positional("OUT.png", o->picture, "PNG to write").required();
  verb.option("--wav", o->sound, "the sound, any file libsndfile reads").required();
  verb.option("--states", o->states, "CSV time_s,signal,value, what `rigsound decode` prints").required();
  verb.option("--rig", o->rig, "take the thresholds from this rig");
  const auto threshold = [&](const char* name, double& bar, const char* help) {
    return verb.option(name, bar, help).shows_default().range(0, info(Signal::kFeedPressureBar).max, "bar");
  };
  o->underfeed =
      threshold("--underfeed", o->underfeed_bar, "feed pressure under which it is underfeed; beats --rig");
  o->overfeed =
      threshold("--overfeed", o->overfeed_bar, "feed pressure over which it is overfeed; beats --rig");
  verb.option("--title", o->timeline.title, "over the picture (default: the name of the sound)");
  verb.option("--width", o->timeline.width, "of the picture")
      .shows_default()
      .range(analysis::kMinTimelineWidth, analysis::kMaxTimelineSide, "pixels");
  verb.option("--height", o->timeline.height, "of the picture")
      .shows_default()
      .range(analysis::kMinTimelineHeight, analysis::kMaxTimelineSide, "pixels");
  verb.callback([o] { draw(*o); });
  verb.details(
      "Situations are coloured and named by the engine's own rule, hysteresis included. Signals that the "
      "states do "
      "not hold are left out. The levels of the spectrogram are relative to a sine of full scale.");
  verb.example("rigsound timeline out/demo.png --wav out/demo.wav --states out/demo.csv");
}

}  // namespace rigsound::tools
