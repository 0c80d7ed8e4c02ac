// What the drill string of one boom follows.
#pragma once

namespace rigsound::string {

/// Neutral as it stands. Whatever changes here moves smoothly in the sound.
struct StringInput {
  double period = 1200;         ///< mean gap between blows, samples, > 0; the piston's bounces follow it
  int rods = 1;                 ///< 1...kMaxRods; a change fades out, 20 ms, and in
  double rock_stiffness = 2e8;  ///< what loads the bit, N/m, 1e5...1e11
  double contact = 1;           ///< 0...1: the feed closes the gap between bit and rock; 0: none is felt
  double exposed_m = 3.66;      ///< of the upper rod outside the hole, 0...; a jump counts as a rod change
  bool broken = false;          ///< a rod has broken: one snap, then both parts ring free until it is mended
};

}  // namespace rigsound::string
