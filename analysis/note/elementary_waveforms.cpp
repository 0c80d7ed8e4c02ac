#include "note/elementary_waveforms.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace rigsound::analysis {
namespace {

double rms(const std::vector<double>& x, std::size_t at, std::size_t length) {
  double sum = 1e-30;
  for (std::size_t i = at; i < std::min(x.size(), at + length); ++i) sum += x[i] * x[i];
  return std::sqrt(sum / static_cast<double>(length));
}

}  // namespace

ElementaryWaveforms::ElementaryWaveforms(const std::vector<double>& subband, std::size_t from, std::size_t to,
                                         int P, int count)
    : from_(from), length_(static_cast<std::size_t>(kPeriods * P)), overlap_(length_ / 4) {
  const std::size_t stretches = (to - from) / length_;
  for (std::size_t i = 0; i < stretches; ++i) level_.push_back(rms(subband, from + i * length_, length_));
  const auto wanted = std::min(static_cast<std::size_t>(count), stretches - 1);
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t at = from + i * (stretches - 1) / wanted * length_;
    const auto begin = subband.begin() + static_cast<std::ptrdiff_t>(at);
    waveforms_.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(length_ + overlap_));
    const double level = rms(subband, at, length_);
    for (double& v : waveforms_.back()) v /= level;
  }
}

void ElementaryWaveforms::play(unsigned seed, std::vector<double>& out) const {
  std::mt19937_64 chance(seed);
  for (std::size_t i = 0; i < level_.size(); ++i) {
    const std::vector<double>& waveform = waveforms_[chance() % waveforms_.size()];
    for (std::size_t n = 0; n < waveform.size(); ++n) {
      double fade = 1;
      if (n < overlap_)
        fade = std::sin(M_PI / 2 * (static_cast<double>(n) + 0.5) / static_cast<double>(overlap_));
      if (n >= length_)
        fade = std::cos(M_PI / 2 * (static_cast<double>(n - length_) + 0.5) / static_cast<double>(overlap_));
      const std::size_t at = from_ + i * length_ + n;
      if (at < out.size()) out[at] += level_[i] * fade * waveform[n];
    }
  }
}

std::size_t ElementaryWaveforms::parameters() const {
  return waveforms_.size() * (length_ + overlap_) + level_.size();
}

}  // namespace rigsound::analysis
