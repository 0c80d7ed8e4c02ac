#include "passes_lanes.hpp"

namespace rigsound::dsp {

template struct Passes<LaneWidth::kFour>;

}  // namespace rigsound::dsp
