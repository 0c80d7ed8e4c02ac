#include "string/bending_modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::string {
namespace {

constexpr double kLow_hz = 200, kHigh_hz = 8000;  // where the decay times of the model hold
constexpr double kFadeDecay_s = 0.005;            // of a mode on its way out at kFadeTo_hz, at most
constexpr int kQuarters = 4;
constexpr int kEager =
    2;  // groups at the top that follow every chunk: their steps would be heard above the modes
constexpr unsigned kVisitEvery = 4;  // chunks
constexpr double kSilent = 1e-40;    // squared; what is less is zeroed before it turns denormal

}  // namespace

BendingModes::BendingModes(const StringModel& model, double sample_rate, dsp::LaneWidth width)
    : kernel_(string_kernel(width)),
      table_(model, sample_rate),
      sample_rate_(sample_rate),
      free_(damping_of(model.bending_low_s, model.bending_high_s)),
      pressed_(damping_of(model.contact_low_s, model.contact_high_s)),
      shortest_m_(kShortest * model.rod_diameter_m),
      fade_to_(warped(kFadeTo_hz, sample_rate)) {
  tuning_.fade_from = warped(kFadeFrom_hz, sample_rate);
  tuning_.fade_scale = 1 / (fade_to_ - tuning_.fade_from);
  tuning_.fade_loss = 3 * dsp::kLn10 / (kFadeDecay_s * sample_rate);
  const TableCut whole = table_.cut(model.rod_length_m);
  int modes = 0;
  while (modes < kMaxModes && whole.at(modes) < fade_to_) ++modes;
  // A blow puts the same energy into every rod.
  gain_ = model.level * model.bending_mix / std::sqrt(modes);
  std::fill(state_.s, state_.s + kMaxModes, 1.0);
  set(model.rod_length_m, 0);
  retune();
}

BendingModes::Damping BendingModes::damping_of(double low_s, double high_s) const noexcept {
  const auto loss = [&](double t60_s) { return 1 - dsp::exp(-3 * dsp::kLn10 / (t60_s * sample_rate_)); };
  const double low = warped(kLow_hz, sample_rate_), high = warped(kHigh_hz, sample_rate_);
  const double slope = (loss(high_s) - loss(low_s)) / (high * high - low * low);
  return {loss(low_s) - slope * low * low, slope};
}

void BendingModes::set(double exposed_m, double contact) noexcept {
  if (exposed_m == exposed_m_ && contact == contact_) return;
  if (exposed_m != exposed_m_) tuning_.cut = table_.cut(std::max(exposed_m, shortest_m_));
  tuning_.gain = gain_ * std::min(1.0, exposed_m / shortest_m_);
  tuning_.loss = free_.loss + contact * (pressed_.loss - free_.loss);
  tuning_.loss_slope = free_.slope + contact * (pressed_.slope - free_.slope);
  exposed_m_ = exposed_m;
  contact_ = contact;
  stale_ = kQuarters;
}

void BendingModes::retune() noexcept {
  silence();
  state_.groups = 0;
  choose_groups();
  for (int group = 0; group < state_.groups; ++group) kernel_.tune(state_, tuning_, group);
  stale_ = turn_ = visited_ = 0;
}

/// A group sounds while its lowest mode does.
void BendingModes::choose_groups() noexcept {
  const auto sounds = [&](int group) { return tuning_.cut.at(kGroup * group) < fade_to_; };
  while (state_.groups < 1 || (state_.groups < kMaxModes / kGroup && sounds(state_.groups)))
    kernel_.tune(state_, tuning_, state_.groups++);
  while (state_.groups > 1 && !sounds(state_.groups - 1)) {
    const int first = kGroup * --state_.groups;
    std::fill(state_.y1 + first, state_.y1 + first + kGroup, 0.0);
    std::fill(state_.y2 + first, state_.y2 + first + kGroup, 0.0);
  }
}

void BendingModes::tune_some() noexcept {
  choose_groups();
  const int eager = std::max(0, state_.groups - kEager);
  for (int group = turn_; group < eager; group += kQuarters) kernel_.tune(state_, tuning_, group);
  for (int group = eager; group < state_.groups; ++group) kernel_.tune(state_, tuning_, group);
  turn_ = (turn_ + 1) % kQuarters;
  --stale_;
}

void BendingModes::forget_silent(int group) noexcept {
  for (int k = kGroup * group; k < kGroup * group + kGroup; ++k)
    if (state_.y1[k] * state_.y1[k] + state_.y2[k] * state_.y2[k] < kSilent) state_.y1[k] = state_.y2[k] = 0;
}

void BendingModes::process(const double* x, bool struck, double* out) noexcept {
  if (stale_ > 0) tune_some();
  ModesDrive drive{x, kChunk, kChunk};
  if (struck) {
    drive.first = 0;
    while (drive.first < drive.last && x[drive.first] == 0) ++drive.first;
    while (drive.last > drive.first && x[drive.last - 1] == 0) --drive.last;
    drive.first -= drive.first % 2;
    drive.last += drive.last % 2;
  }
  kernel_.modes(state_, drive, out);
  if (++visited_ % kVisitEvery == 0) forget_silent(visited_ / kVisitEvery % state_.groups);
}

double BendingModes::frequency_hz(int mode) const noexcept {
  return dsp::atan2(state_.s[mode - 1], state_.c[mode - 1]) / dsp::kTwoPi * sample_rate_;
}

double BendingModes::t60_s(int mode) const noexcept {
  return -6 * dsp::kLn10 / (dsp::log(state_.b2[mode - 1]) * sample_rate_);
}

double BendingModes::energy() const noexcept {
  const ModesState& s = state_;
  double sum = 0;
  for (int k = 0; k < kGroup * s.groups; ++k) {
    const double q = (s.c[k] * s.y1[k] - s.b2[k] * s.y2[k]) / s.s[k];
    sum += q * q + s.y1[k] * s.y1[k];
  }
  return sum;
}

void BendingModes::silence() noexcept {
  std::memset(state_.y1, 0, sizeof state_.y1);
  std::memset(state_.y2, 0, sizeof state_.y2);
}

}  // namespace rigsound::string
