// DrillBench v1: numbered clips with exact truth. An id fixes every sample.
#pragma once

#include <vector>

#include "simulate/click_voice.hpp"

namespace rigsound::analysis {

struct DrillBenchClip {
  std::vector<double> clean;           ///< 48 kHz; the nominal clip (rate_factor 1) has RMS 1
  std::vector<SimulatedClick> clicks;  ///< those that sound, ascending
  ClickEnvelope envelope;
  double T0 = 0;  ///< samples, at the nominal rate
};

/// True for the ids whose parameters exist: 0-31, 100-131, 200-231, ...; 24-31 of a hundred are the hard ones
/// (bounces, missed and double impacts).
bool drillbench_id(int id);

/// `rate_factor` plays the very same impacts closer together (> 1) or further apart, without touching their
/// sound.
DrillBenchClip drillbench_clip(int id, double seconds, double rate_factor = 1);

/// The diesel and hydraulics of clip `id`, RMS 1.
std::vector<double> drillbench_background(int id, double seconds);

}  // namespace rigsound::analysis
