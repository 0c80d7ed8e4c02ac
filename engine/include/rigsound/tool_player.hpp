// One tool played by itself: what the engine does with it, without a rig around it.
#pragma once

#include <cstdint>
#include <memory>

#include "rigsound/impact.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound {

class ToolPlayer {
 public:
  /// Designs the tool at `sample_rate`, Hz. Throws std::invalid_argument, naming the key, when the model
  /// makes no sense. Thread: OFF.
  ToolPlayer(const ToolModel& model, double sample_rate, std::uint64_t seed);
  ~ToolPlayer();
  ToolPlayer(ToolPlayer&&) noexcept;
  ToolPlayer& operator=(ToolPlayer&&) noexcept;

  /// The next kChunk samples, struck by `impacts`. Thread: RT.
  void process(const Impacts& impacts, double* out) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rigsound
