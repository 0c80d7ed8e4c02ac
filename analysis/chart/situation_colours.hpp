// The colours of the drilling situations, the same in every picture.
#pragma once

#include <array>

#include "chart/paint.hpp"
#include "rigsound/machine/situation.hpp"

namespace rigsound::chart {

/// In the order of Situation.
constexpr std::array<Colour, kSituationCount> kSituationColours = {
    {{106, 183, 118}, {106, 169, 219}, {226, 104, 86}, {202, 160, 220}, {141, 96, 184}}};

}  // namespace rigsound::chart
