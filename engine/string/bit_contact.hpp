// The bit on the rock: a spring that loads along its stiffness, unloads stiffly and never pulls.
#pragma once

namespace rigsound::string {

/// Forces are waves: with F_i down the string and F on the rock, F - F_i goes back up. The spring's state s,
/// s^2 / 4K, is the energy it holds, so that the bit never returns more than it got, whatever its stiffness
/// and its gap are set to and when:
///   2 F_i > s:  F = (s + 2 K F_i) / (1 + K), s = F + K (2 F_i - F);   else F = s = max(2 F_i, 0).
class BitContact {
 public:
  /// `loading_samples`: T = Z / k, > 0. Thread: RT.
  void set_loading(double loading_samples) noexcept;

  /// How far the feed lets the bit stand off the rock, in units of force times samples; negative: out of
  /// reach. The bit crosses what it stands off before the rock feels it. Thread: RT.
  void set_gap(double gap) noexcept;

  /// Share of the gap by which a bit that no wave moves goes back into it each sample. Thread: OFF.
  void set_return(double share) noexcept { return_ = share; }

  /// `down`: F_i, `up`: F - F_i. Thread: RT.
  void process(const double* down, double* up, int frames) noexcept;

  double energy() const noexcept { return s_ * s_ / (4 * K_); }
  /// At rest in its gap.
  void silence() noexcept { s_ = 0, off_ = gap_ > 0 ? gap_ : 0; }

 private:
  void press(const double* down, double* up, int frames) noexcept;
  void rattle(const double* down, double* up, int frames) noexcept;

  double K_ = 0.05, share_ = 0.05 / 1.05;  ///< K = 1 / (2 T), K / (1 + K)
  double s_ = 0;
  double gap_ = 0, off_ = 0, return_ = 0;  ///< how far it may stand off, and does
};

}  // namespace rigsound::string
