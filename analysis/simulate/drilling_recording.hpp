// Simulated drilling while the feed stands still or moves.
#pragma once

#include <vector>

#include "simulate/click_process.hpp"
#include "simulate/drilling_laws.hpp"
#include "simulate/take.hpp"

namespace rigsound::analysis {

/// The drill is fed from one second after the start to one second before the end; the feed goes straight from
/// one pressure to the other.
struct DrillingCourse {
  double seconds = 18;  ///< length of the recording, >= 4
  double start_feed_bar = DrillingLaws::kNormal_bar, end_feed_bar = DrillingLaws::kNormal_bar;
  int rods = 1;
  double snr_db = 8;  ///< of normal drilling with one rod over the background

  static constexpr double kAlone_s = 1;  ///< the diesel alone, before and after
  double begin_s() const { return kAlone_s; }
  double end_s() const { return seconds - kAlone_s; }
  double feed_bar(double time_s) const;  ///< while drilling
};

struct DrillingRecording {
  std::vector<SimulatedClick> clicks;     ///< ascending; beta 1: the mean impact at the feed of that moment
  std::vector<double> clean, background;  ///< 48 kHz, full scale = 1; the recording is their sum
};

/// The machine is that of `laws`: impacts and noises depend on `take`. Thread: OFF.
DrillingRecording simulate_drilling(const DrillingCourse& course, const DrillingLaws& laws, const Take& take);

/// Background of a recording in which the diesel goes from one speed to another, at `rms`.
std::vector<double> recorded_background(double seconds, double start_rpm, double end_rpm, double rms,
                                        const Take& take);

constexpr double kNormCorrelation = 0.3;  ///< lag-1, of the clicks' norms

}  // namespace rigsound::analysis
