// What the recording of one impact tells of how its bands decay, and of how loud they are.
#pragma once

#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "rigsound/analysis/tool_fit.hpp"
#include "tool_fit/impact_sound.hpp"

namespace rigsound::analysis {

constexpr double kHeardFall_db = 10;  ///< a decay is told when the band falls this far above the noise

/// Share of a band's recorded energy that is the impact's; 95 %.
struct SignalShare {
  double low = 0, high = 1;

  bool told() const { return low > 0.25; }  ///< the level is known to 6 dB at least
};

struct BandEvidence {
  DecayBounds decay;
  SignalShare share;
};

/// Looks at one impact band by band. Thread: OFF.
///
/// The power of a band, sampled as often as its width gives independent values, is taken as exponentially
/// distributed round A exp(-a t) + N. N is free, but not over what the recording has before the onset. The
/// bounds are those of the profile likelihood, with the dispersion of the residuals and their correlation,
/// so that beating modes widen them. What rings longer than the sound lasts, sinks into the noise before it
/// has fallen by kHeardFall_db, or has bounds further apart than a factor of four, has a lower bound only.
class DecayEvidence {
 public:
  explicit DecayEvidence(const RecordedImpact& impact);

  /// Of the third octave around `centre_hz`.
  BandEvidence band(double centre_hz);

 private:
  std::vector<double> band_power(double centre_hz, double width_hz);

  std::size_t onset_, samples_, size_;
  std::vector<std::complex<double>> spectrum_;
  Eigen::FFT<double> fft_;
};

}  // namespace rigsound::analysis
