// From the clicks of a recording to a bank the engine can play.
#pragma once

#include <string>
#include <vector>

#include "rigsound/analysis/chain.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// Figures of a bank, for its report and the lint.
struct BankFigures {
  int clicks_found = 0;
  int segments = 0, segments_drilling = 0;
  double rate_hz = 0;
  double level_db = 0;  ///< of the drilling, dB re full scale
  double snr_db = 0;    ///< drilling against background; +infinity when taken as clean
  double decay_s = 0;   ///< time in which the envelope falls by 60 dB
  double longest_click_s = 0;
  double ltas_error_db = 0;  ///< third-octave levels, resynthesised against what the bank aims at: recorded,
                             ///< with what the denoiser took from the drilling given back
  double ltas_denoised_error_db = 0;  ///< the same against the denoised recording as it is
  double modulation_error_db = 0;
  std::string doubt;  ///< what speaks against the label's word that it drills; empty: nothing
  int machine = 1;    ///< which of the part's machines the bank is of
  std::vector<double> machine_rates_hz;  ///< of all of them, the loudest first
};

struct BuiltBank {
  ClickBank bank;
  BankFigures figures;
};

/// Extraction, statistics, choice and equaliser on the drilling segments of one part, or with Method::kPaper
/// sections 3.6 and 3.7 of the paper. The bank has at most `count` clicks and no name yet. Errors: InputError
/// naming `part` when there are too few clicks. Thread: OFF.
BuiltBank build_bank(const SegmentedResult& recording, Method method, int count, const std::string& part);

}  // namespace rigsound::analysis
