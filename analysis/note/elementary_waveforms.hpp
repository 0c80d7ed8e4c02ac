// The first subband from a dozen stretches of itself (section 5, after d'Alessandro and Richard).
#pragma once

#include <vector>

namespace rigsound::analysis {

class ElementaryWaveforms {
 public:
  /// Cuts `count` waveforms of kPeriods periods from samples from ... to of `subband`, spread evenly, and the
  /// short-time power they will follow. Thread: OFF.
  ElementaryWaveforms(const std::vector<double>& subband, std::size_t from, std::size_t to, int P, int count);

  /// Adds them to `out` over from ... to in random order, overlapped with equal power. Thread: OFF.
  void play(unsigned seed, std::vector<double>& out) const;

  std::size_t parameters() const;

 private:
  static constexpr int kPeriods = 8;
  std::size_t from_, length_, overlap_;
  std::vector<std::vector<double>> waveforms_;  // unit power, length + overlap samples
  std::vector<double> level_;                   // rms of every stretch of `length`
};

}  // namespace rigsound::analysis
