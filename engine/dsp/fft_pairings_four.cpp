#include "fft_pairings_lanes.hpp"

namespace rigsound::dsp {

template struct FftPairings<float, LaneWidth::kFour>;
template struct FftPairings<double, LaneWidth::kFour>;

}  // namespace rigsound::dsp
