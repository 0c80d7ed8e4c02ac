// An FIR that only changes how loud each frequency is, as early in time as possible.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace rigsound::analysis {

/// Minimum-phase FIR of `taps` samples whose gain at f (Hz, 48 kHz) is `gain_db(f)`, by folding the real
/// cepstrum of an 8192-point design. Thread: OFF.
Eigen::ArrayXd minimum_phase_fir(const std::function<double(double)>& gain_db, int taps);

}  // namespace rigsound::analysis
