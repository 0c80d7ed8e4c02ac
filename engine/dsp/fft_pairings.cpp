#include "fft_pairings_lanes.hpp"

namespace rigsound::dsp {

template struct FftPairings<float, LaneWidth::kTwo>;
template struct FftPairings<double, LaneWidth::kTwo>;

}  // namespace rigsound::dsp
