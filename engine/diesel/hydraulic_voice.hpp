// Pump strokes and oil flow, as loud as the feed pressure makes them.
#pragma once

#include "diesel/tone_bank.hpp"
#include "rigsound/dsp/all_pole.hpp"

namespace rigsound::diesel {

class HydraulicVoice {
 public:
  HydraulicVoice(const DieselModel& model, double sample_rate, std::uint64_t seed);  ///< Thread: OFF

  /// Adds kChunk samples to `out`. `f`: cycles a second; `feed`: 0...1 of the overfeed pressure; `running`:
  /// 0...1, the pump turns with the engine. Thread: RT.
  void add(double f, double feed, double running, double* out) noexcept;

  void reset() noexcept { colour_.reset(); }  ///< Thread: RT

 private:
  double exponent_, flow_;
  ToneBank pump_;
  dsp::AllPole colour_;
  dsp::RandomField random_;
  dsp::Ramp gain_;
  std::uint64_t sample_ = 0;
};

}  // namespace rigsound::diesel
