// What the layers of an engine cost, and whether the machine let that be measured.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/block_costs.hpp"
#include "rigsound/config/sounding_rig.hpp"

namespace rigsound::tools {

/// What is played, again and again.
struct Workload {
  config::SoundingRig rig;
  SoundSet sounds;
  std::function<std::unique_ptr<audio::StateSource>()> states;  ///< the same at each call
  std::uint64_t settling = 0;                                   ///< blocks before the first that counts
};

/// Microseconds of a block of one layer: of its least times. A layer's are what a block costs with it less
/// what the same block costs without.
struct LayerCost {
  std::string name;
  double mean_us = 0, p50_us = 0, p99_us = 0, p999_us = 0, worst_us = 0;
  std::optional<double> instructions_a_block;
  long blocks = 0, over_deadline = 0;  ///< blocks that take longer than they last
};

struct BenchResult {
  std::vector<LayerCost> layers;  ///< drill, tool, background, scene+mix, and the engine whole
  double block_us = 0;            ///< how long a block lasts
  int frames = 0;                 ///< of a block
  double had = 0;                 ///< of the time that the runs took: the share of it this process had a core
  double differ = 0;              ///< how much dearer the second best run of the engine was than its best

  const LayerCost& engine() const { return layers.back(); }
  bool quiet() const;  ///< enough to trust the figures
};

/// `shown` is told how much of the work is done, 0...1. Errors: InputError. Thread: OFF.
BenchResult layer_costs(const Workload& work, const std::function<void(double)>& shown);

}  // namespace rigsound::tools
