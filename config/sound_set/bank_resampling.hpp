// Banks at the engine's rate.
#pragma once

#include <optional>

#include "rigsound/click_bank.hpp"
#include "rigsound/dsp/rate_converter.hpp"
#include "sound_set/click_store.hpp"

namespace rigsound::config {

/// Thread: OFF.
class BankResampler {
 public:
  explicit BankResampler(double sample_rate) : sample_rate_(sample_rate) {}

  /// The same bank at `sample_rate` Hz: clicks resampled, times and decays in the new samples.
  ClickBank resampled(ClickBank bank);

 private:
  Click resampled(const Click& click);

  double sample_rate_;
  ClickStore store_{LargeBlock::kPiece};
  std::optional<dsp::RateConverter>
      converter_;  ///< from the rate of the last bank, which is mostly that of all
};

}  // namespace rigsound::config
