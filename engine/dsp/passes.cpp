#include "passes_lanes.hpp"

namespace rigsound::dsp {

template struct Passes<LaneWidth::kTwo>;

}  // namespace rigsound::dsp
