// The worst that may reach an engine: states no sender should send, sound sets the readers only just accept.
#pragma once

#include <cstdint>

#include "rigsound/dsp/random.hpp"
#include "rigsound/engine.hpp"

namespace rigsound::tests {

/// Every draw differs from the last; the same seed, the same draws.
class HostileInput {
 public:
  explicit HostileInput(std::uint64_t seed) : random_(seed, 77) {}

  /// Any bits in every field: NaN, infinite, denormal, the largest, values no enumeration has.
  MachineState state();

  /// Options and sounds that require_valid() lets pass, most numbers at an end of their range; clicks of
  /// full-band noise, square waves, lone samples, constants.
  EngineOptions options();
  SoundSet sounds(double sample_rate);

  double uniform() { return random_.uniform(drawn_++, 0); }
  int below(int count) { return static_cast<int>(uniform() * count); }

 private:
  class AtTheEdges;

  float number();
  std::vector<float> click();
  ClickBank bank(double sample_rate);
  ToolModel tool(double sample_rate);
  StringModel string();
  DieselModel diesel();

  dsp::RandomField random_;
  std::uint64_t drawn_ = 0;
};

}  // namespace rigsound::tests
