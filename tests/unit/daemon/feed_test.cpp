// A feed puts what its bus reports onto the board, whatever kind of bus it is.
#include "feed.hpp"

#include <doctest/doctest.h>

#include <future>

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

/// Reports one thing a round, then waits for the end.
class ScriptedBus : public Bus {
 public:
  ScriptedBus(BusListener& listener, std::promise<void>& played) : listener_(listener), played_(played) {}

  const std::string& name() const override { return name_; }
  const std::vector<SignalId>& signals() const override { return signals_; }
  std::vector<BusCounter> counters() const override { return {{"frames_seen", 2}}; }
  void step() override {
    const Reading good[] = {{{Signal::kFeedPressureBar, 1}, 85, Validity::kValid, 3.5},
                            {{Signal::kEngineRpm}, 1800, Validity::kValid, 3.5}};
    const Reading lost{{Signal::kEngineRpm}, 0, Validity::kBusDown, 4};
    switch (round_++) {
      case 0:
        return listener_.up();
      case 1:
        return listener_.readings(good, 2);
      case 2:
        return listener_.readings(&lost, 1);
      case 3:
        return listener_.down("drum 1: the cable is out");  // as drivers say it
      case 4:
        return played_.set_value();
      default:
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

 private:
  BusListener& listener_;
  std::promise<void>& played_;
  std::string name_ = "drum 1";
  std::vector<SignalId> signals_ = {{Signal::kEngineRpm}};
  int round_ = 0;
};

}  // namespace

TEST_CASE("Readings reach the board with their time, news and counters the snapshot") {
  std::promise<void> played;
  StateExchange exchange{SafetyOptions{}};
  const Feed feed([&](BusListener& listener) { return std::make_unique<ScriptedBus>(listener, played); },
                  exchange);
  played.get_future().wait();
  const SignalBoard board = exchange.board();
  CHECK(board.entry({Signal::kFeedPressureBar, 1}).value == 85);
  CHECK(board.entry({Signal::kFeedPressureBar, 1}).seen_s == 3.5);
  CHECK(board.entry({Signal::kFeedPressureBar, 1}).validity == Validity::kValid);
  CHECK(board.entry({Signal::kEngineRpm}).value == 1800);
  CHECK(board.entry({Signal::kEngineRpm}).validity == Validity::kBusDown);
  const BusSnapshot snapshot = feed.snapshot();
  CHECK(snapshot.name == "drum 1");
  CHECK_FALSE(snapshot.up);
  CHECK(snapshot.problem == "the cable is out");
  REQUIRE(snapshot.counters.size() == 1);
  CHECK(snapshot.counters[0].count == 2);
}
