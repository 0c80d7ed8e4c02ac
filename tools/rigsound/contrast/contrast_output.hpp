// What `rigsound contrast` prints. Thread: OFF.
#pragma once

#include "rigsound/analysis/contrast.hpp"

namespace rigsound::tools {

void print_contrast_table(const analysis::Contrast& contrast);
void print_contrast_json(const analysis::Contrast& contrast);

}  // namespace rigsound::tools
