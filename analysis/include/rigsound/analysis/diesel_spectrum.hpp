// What a diesel sounds like at one speed, as a picture shows it: narrow bands and orders.
#pragma once

#include "rigsound/analysis/curve.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/machine/fields.hpp"

namespace rigsound::analysis {

/// Slower ones take minutes to hear enough cycles of.
constexpr Range kSpectrumSpeeds{100, 4000, "r/min"};

struct DieselSpectrum {
  double rpm = 0;
  Curve bands;   ///< Hz from 20 to 10000, dB re full scale in bands of 1/8 order of the cycle
  Curve orders;  ///< Hz of orders 1, 2, ... of the cycle below 400 Hz, dB re full scale
};

/// What the engine's own voice makes of `model` at a speed in kSpectrumSpeeds and a load 0...1; where nothing
/// was learned it plays the nearest that was. Some tenths of a second. Thread: OFF.
DieselSpectrum modelled_spectrum(const DieselModel& model, double rpm, double load);

/// The same of a recording at one speed; `angle_samples` as in the model it is beside. Its first section when
/// it is a run-up. Errors: InputError as learn_diesel. Thread: OFF.
DieselSpectrum recorded_spectrum(const DieselTake& take, int angle_samples);

}  // namespace rigsound::analysis
