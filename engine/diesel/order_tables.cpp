#include "diesel/order_tables.hpp"

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::diesel {
namespace {

constexpr double kFadeFrom = 0.42, kFadeTo = 0.46;  // of the sampling rate: orders fade out before they fold

}  // namespace

OrderTables::Source::Source(const SourcePoint& point) : level(point.level) {
  for (const double phase : point.phase) re.push_back(dsp::cos(phase)), im.push_back(dsp::sin(phase));
}

OrderTables::OrderTables(const DieselModel& model, double sample_rate)
    : model_(model),
      sample_rate_(sample_rate),
      fft_(model.angle_samples),
      re_(static_cast<std::size_t>(model.angle_samples)),
      im_(re_.size()) {}

void OrderTables::put(bool second, const Source& source, double f) {
  const std::size_t last = std::min(source.level.size(), re_.size() / 2 - 1);
  for (std::size_t k = 1; k <= last; ++k) {
    const double f_k = static_cast<double>(k) * f;
    const double fade = std::clamp((kFadeTo - f_k / sample_rate_) / (kFadeTo - kFadeFrom), 0.0, 1.0);
    if (fade == 0) break;
    const double body = body_db(model_.body, f_k) * (dsp::kLn10 / 20);
    const double half = fade * dsp::exp(source.level[k - 1] + body) / 2;
    const double re = half * source.re[k - 1], im = half * source.im[k - 1];
    const std::size_t mirror = re_.size() - k;
    re_[k] += second ? -im : re, im_[k] += second ? re : im;
    re_[mirror] += second ? im : re, im_[mirror] += second ? re : -im;
  }
}

void OrderTables::take(std::vector<float>& first, std::vector<float>& second) {
  fft_.inverse(re_.data(), im_.data());
  first.assign(re_.begin(), re_.end());
  second.assign(im_.begin(), im_.end());
  std::fill(re_.begin(), re_.end(), 0.0);
  std::fill(im_.begin(), im_.end(), 0.0);
}

}  // namespace rigsound::diesel
