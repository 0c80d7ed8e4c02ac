#include "analyzer/bus_course.hpp"

#include <memory>

#include "rigsound/feed_rule.hpp"
#include "rigsound/log/bus_log.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/machine/state_resolver.hpp"

namespace rigsound::analysis {
namespace {

bool said(const SignalBoard& board, Signal signal) { return board.entry({signal, 0}).ever_good(); }

BusMoment moment_of(const MachineState& state, const SignalBoard& board, const scene::FeedRule& rule) {
  const BoomState& boom = state.boom[0];
  BusMoment moment;
  if (rule.hammering()) moment.situation = rule.situation();
  moment.feed_bar = static_cast<double>(boom.feed_pressure_bar);
  moment.rpm = static_cast<double>(state.engine_rpm);
  if (said(board, Signal::kPercussionPressureBar))
    moment.percussion_bar = static_cast<double>(boom.percussion_pressure_bar);
  if (said(board, Signal::kRodCount)) moment.rods = boom.rod_count;
  if (said(board, Signal::kRock)) moment.rock = boom.rock;
  return moment;
}

}  // namespace

BusCourse read_bus_course(const config::Rig& rig, const std::filesystem::path& log_file) {
  const std::unique_ptr<log::BusLog> log = log::open_log(log_file, config::buses_of(rig), {});
  SignalBoard board;
  StateResolver resolver;
  scene::FeedRule rule(rig.engine.scene);
  BusCourse course;
  while (log->next_s()) {
    const double now_s = static_cast<double>(course.moments.size()) * kBusStep_s;
    log->read_until(now_s, board);
    const MachineState state = resolver.resolve(board, rig.safety, now_s);
    rule.update(state.boom[0]);
    course.moments.push_back(moment_of(state, board, rule));
  }
  if (!said(board, Signal::kFeedPressureBar))
    throw InputError(log_file.string(), "says nothing of feed_pressure_bar, expected the bus that " +
                                            rig.file.string() + " describes");
  return course;
}

}  // namespace rigsound::analysis
