// What the background layer follows.
#pragma once

namespace rigsound::background {

struct BackgroundControls {
  double rpm = 0;   ///< r/min, 0: diesel off
  double load = 0;  ///< 0...1, smoothed
  double feed = 0;  ///< hydraulic pressure, 0...1 of the overfeed threshold, smoothed
};

}  // namespace rigsound::background
