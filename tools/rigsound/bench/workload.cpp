#include "bench/workload.hpp"

#include <utility>

#include "bench/formula_sounds.hpp"
#include "bench/steady_states.hpp"
#include "rigsound/audio/excerpt.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/session/log_states.hpp"

namespace rigsound::tools {
namespace {

constexpr float kWorking_rpm = 1800;
constexpr double kSettling_s = 1;

class WholeLog : public audio::StateSource {
 public:
  WholeLog(std::unique_ptr<log::BusLog> log, const config::Rig& rig, std::uint64_t last)
      : log_(std::move(log)), states_(*log_, rig.safety, rig.engine), part_(states_, last) {}
  const MachineState* state_of(std::uint64_t number) override { return part_.state_of(number); }

 private:
  std::unique_ptr<log::BusLog> log_;
  session::LogStates states_;
  audio::EndingStates part_;
};

void drill_steadily(Workload& work, double seconds) {
  const EngineOptions& options = work.rig.engine;
  MachineState state;
  state.engine_rpm = kWorking_rpm;
  for (std::size_t b = 0; b < options.booms.size(); ++b)
    state.boom[b].feed_pressure_bar =
        static_cast<float>((options.scene.underfeed_bar + options.scene.overfeed_bar) / 2);
  work.settling = audio::blocks_of(0, kSettling_s, options).last;
  const std::uint64_t blocks = work.settling + audio::blocks_of(0, seconds, options).last;
  work.states = [state, blocks] { return std::make_unique<SteadyStates>(state, blocks); };
}

}  // namespace

Workload formula_workload(double seconds) {
  Workload work;
  work.rig.engine = full_options();
  work.rig.engine.booms = {{"boom", 0, 0, 0}};
  work.sounds = formula_sounds(work.rig.engine.sample_rate);
  drill_steadily(work, seconds);
  return work;
}

Workload rig_workload(const std::string& file, double seconds) {
  config::Rig rig = config::load_rig(file, config::Buses::kLeftOut);
  Workload work;
  work.sounds = config::load_sounds(rig);
  work.rig = rig;
  drill_steadily(work, seconds);
  return work;
}

Workload log_workload(const std::string& file, const LogArguments& log, double seconds) {
  config::Rig rig = config::load_rig(file);
  Workload work;
  work.sounds = config::load_sounds(rig);
  work.rig = rig;
  const std::uint64_t last = audio::blocks_of(0, seconds, rig.engine).last;
  work.states = [rig, log, last]() -> std::unique_ptr<audio::StateSource> {
    return std::make_unique<WholeLog>(log::open_log(log.log, config::buses_of(rig), log_options(log)), rig,
                                      last);
  };
  return work;
}

}  // namespace rigsound::tools
