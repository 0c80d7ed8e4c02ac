#include "fft_pairings_lanes.hpp"

namespace rigsound::dsp {

template struct FftPairings<LaneWidth::kFour>;

}  // namespace rigsound::dsp
