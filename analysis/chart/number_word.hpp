// Numbers as people read them.
#pragma once

#include <string>

namespace rigsound::chart {

/// "−12.3"; a dash for what is not finite. Thread: any.
std::string number_word(double value, int digits);

}  // namespace rigsound::chart
