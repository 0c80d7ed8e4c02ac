#include "diesel/grain_source.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::diesel {
namespace {

constexpr double kLoadOctaves = 1.0;  // a load of 1 is as far away as an octave of speed

double distance(const DieselPoint& point, double rpm, double load) noexcept {
  const double octaves = dsp::log(std::max(rpm, 1.0) / point.rpm) / dsp::kLn2;
  const double loads = kLoadOctaves * (load - point.load);
  return std::sqrt(octaves * octaves + loads * loads);
}

}  // namespace

GrainSource::GrainSource(const DieselModel& model, std::uint64_t seed)
    : model_(&model),
      random_(seed, 42),
      M_(model.slot_samples()),
      cycle_samples_(model.angle_samples),
      overlap_samples_(static_cast<int>(kGrainOverlap * model.angle_samples)) {
  for (int i = 0; i < overlap_samples_; ++i)
    fade_in_.push_back(dsp::sin(dsp::kPi / 2 * (i + 0.5) / overlap_samples_));
}

void GrainSource::pick(double rpm, double load) noexcept {
  std::size_t nearest = 0, second = 0;
  double d1 = 1e9, d2 = 1e9;
  for (std::size_t i = 0; i < model_->points.size(); ++i) {
    const double d = distance(model_->points[i], rpm, load);
    if (d < d1)
      second = nearest, d2 = d1, nearest = i, d1 = d;
    else if (d < d2)
      second = i, d2 = d;
  }
  const bool far = model_->points.size() > 1 && random_.uniform(cycle_, 0) < d1 / (d1 + d2 + 1e-12);
  const std::size_t point = far ? second : nearest;
  const auto count = model_->points[point].grains.size();
  // Among all but the last one: draw from one fewer and step over it.
  const bool skip = point == last_point_ && cycle_ > 0 && count > 1;
  auto grain =
      static_cast<std::size_t>(random_.uniform(cycle_, 1) * static_cast<double>(count - (skip ? 1 : 0)));
  if (skip && grain >= last_grain_) ++grain;
  last_point_ = point, last_grain_ = grain;
  before_ = now_;
  now_ = model_->points[point].grains[grain].data();
}

void GrainSource::produce(double rpm, double load, double* out) noexcept {
  if (at_ == 0) pick(rpm, load);
  for (int i = 0; i < M_; ++i) out[i] = static_cast<double>(now_[at_ + i]);
  if (at_ < overlap_samples_ && before_)
    for (int i = 0; i < M_; ++i)
      out[i] = out[i] * fade_in_[static_cast<std::size_t>(at_ + i)] +
               static_cast<double>(before_[cycle_samples_ + at_ + i]) *
                   fade_in_[static_cast<std::size_t>(overlap_samples_ - 1 - at_ - i)];
  at_ += M_;
  if (at_ == cycle_samples_) at_ = 0, ++cycle_;
}

}  // namespace rigsound::diesel
