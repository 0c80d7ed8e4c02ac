// What a blind listening test plays (ITU-R BS.1534-3): excerpts of one length and loudness, and the low
// anchor. Sounds are at kAnalysisRate. Thread: OFF.
#pragma once

#include <cstddef>
#include <vector>

namespace rigsound::analysis {

/// `length` samples of `x` from `from` on, zeros behind its end; the first and the last 5 ms are faded, so
/// that it can be heard over and over without a click.
std::vector<float> excerpt(const std::vector<float>& x, std::size_t from, std::size_t length);

/// `x` through the 3.5 kHz low-pass of the low anchor, without delay: within 0.1 dB up to 3.5 kHz, -25 dB at
/// 4 kHz, -50 dB from 4.5 kHz on.
std::vector<float> low_anchor(const std::vector<float>& x);

/// A gain for each of `sounds`, dB: with it each is as loud as the first by ISO 532-1 to 0.01 phon, and none
/// is over -1 dBFS. What would need more than 40 dB, such as silence, is left as it is.
std::vector<double> matching_gains_db(const std::vector<std::vector<float>>& sounds);

}  // namespace rigsound::analysis
