// What a change is looked for in: band levels and rate, ten times a second.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rigsound/analysis/sound_reader.hpp"
#include "rigsound/progress.hpp"

namespace rigsound::analysis {

constexpr double kFeatureHop_s = 0.1;  ///< nearly
constexpr int kFeatureBands = 8;       ///< octaves from 88 Hz up
constexpr double kRateWindow_s = 1;    ///< a rate is that of so much sound around its frame

struct Features {
  double hop_s = kFeatureHop_s;  ///< from frame to frame; a whole number of samples
  Eigen::ArrayXXd levels;        ///< bands x frames, dB re full scale
  std::vector<double> rate_hz;   ///< per frame; 0: no steady rhythm

  long frames() const { return levels.cols(); }
};

/// Thread: OFF.
Features features_of(SoundReader& sound, const Progress& progress);

}  // namespace rigsound::analysis
