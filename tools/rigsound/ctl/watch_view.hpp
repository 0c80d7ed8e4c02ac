// The daemon's status on one screen: meters and buses always in sight, a column a boom.
#pragma once

#include <string>

#include "ctl/control_client.hpp"

namespace rigsound::tools {

struct Screen {
  int columns = 80;
  int rows = 24;  ///< 0: as many as it takes
};

/// Lines of at most `columns`, at most `rows` of them, without a newline at the end. What does not fit is
/// counted in the last line. Four booms of six signals on two buses fit 80 x 24.
std::string watch_text(const Json& status, const Screen& screen);

/// The same while there is no status, because of `why`.
std::string waiting_text(const std::string& why, const Screen& screen);

}  // namespace rigsound::tools
