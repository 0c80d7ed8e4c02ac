// One click bank played by itself: what the engine does with it, without a rig around it.
#pragma once

#include <cstdint>
#include <memory>

#include "rigsound/click_bank.hpp"
#include "rigsound/impact.hpp"
#include "rigsound/machine/machine_state.hpp"

namespace rigsound {

/// Endless synthesis of one bank (drilling paper, section 3.8) with the paper's six controls. Uses the
/// very impact train and click voices of the engine.
class BankPlayer {
 public:
  /// `bank` is copied; it plays at its own sample rate. Throws std::invalid_argument when the bank is
  /// unusable (no clicks, no period). Thread: OFF.
  BankPlayer(const ClickBank& bank, std::uint64_t seed);
  ~BankPlayer();
  BankPlayer(BankPlayer&&) noexcept;
  BankPlayer& operator=(BankPlayer&&) noexcept;

  /// The next kChunk samples, full scale 1. Thread: RT.
  void process(const DrillControls& controls, double* out) noexcept;

  /// The blows that started in the last chunk. Thread: RT.
  Impacts impacts() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rigsound
