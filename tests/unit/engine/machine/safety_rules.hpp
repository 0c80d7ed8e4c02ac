// One rule for every signal.
#pragma once

#include "rigsound/machine/safety.hpp"

namespace rigsound::tests {

/// Absent after half a second, each of them.
inline SafetyOptions rules(SafetyAction action, double fade_s) {
  SafetyOptions options;
  for (SafetyRule& rule : options.rule) rule = {0.5, action};
  options.fade_s = fade_s;
  return options;
}

}  // namespace rigsound::tests
