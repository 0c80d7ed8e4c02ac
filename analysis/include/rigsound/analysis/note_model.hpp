// The harmonic-band wavelet paper's own model: a sustained note from its attack, its decay and a few numbers.
#pragma once

#include <string>
#include <vector>

namespace rigsound::analysis {

struct NoteSettings {
  int N = 0;                    ///< wavelet scales, 1...6 (section 5: normally 4 or 5); 0: 4, but 3 with
                                ///< kept harmonics, so that they hold twice the width around each
  bool one_over_f = false;      ///< two numbers a channel instead of an energy for every subband (section 3)
  bool keep_harmonics = false;  ///< scaling coefficients kept: the harmonics and their envelopes as they were
  bool colour = false;          ///< AR filters of order 10, 8, 6, ... from the second subband on
  bool time_varying = false;    ///< energies in windows of 20 coefficients
  int waveforms = 0;            ///< elementary waveforms for the first subband, a dozen or more; 0: noise
  unsigned seed = 1;
};

struct NoteModel {
  std::vector<float> sound;  ///< resynthesised, kAnalysisRate, as long as the recording
  double f0 = 0;             ///< Hz, mean over the steady part
  int P = 0;                 ///< channels: angle samples a period
  double steady_from_s = 0, steady_to_s = 0;
  int periods = 0;             ///< of the part that is modelled
  std::size_t parameters = 0;  ///< of that part
  double ratio = 0;            ///< its samples per parameter
  double whole_ratio = 0;      ///< the note's samples per number kept, attack and decay included
  double at_db = 0, near_db = 0, between_db = 0;  ///< spectrum error within 1/8, 1/8...1/4, over 1/4 of f0
                                                  ///< around the harmonics up to 10 kHz, rms over harmonics
};

/// Pitch by autocorrelation decides where the note is steady; only that part is modelled, attack and decay
/// keep all their coefficients. Errors: InputError (`source` names the note): no steady pitch of 0.3 s.
/// Thread: OFF.
NoteModel model_note(const std::string& source, const std::vector<float>& mono, const NoteSettings& settings);

}  // namespace rigsound::analysis
