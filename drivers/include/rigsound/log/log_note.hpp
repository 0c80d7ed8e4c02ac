// What a user should know of a log.
#pragma once

#include <string>

namespace rigsound::log {

struct LogNote {
  std::string text;
  int line = 0;  ///< of the file; 0: it is about the whole
};

/// `12.3`
std::string seconds_text(double seconds);

}  // namespace rigsound::log
