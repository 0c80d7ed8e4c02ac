#include "string/longitudinal_string.hpp"

#include <algorithm>
#include <cstring>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::string {
namespace {

constexpr int kSlack = 16 * kChunk;  // samples a line takes before it is moved back to its start
constexpr int kBehind = 2;           // samples the reflection at the shank looks back beyond its delay

int longest_delay(const std::vector<StringTuning>& tunings) noexcept {
  int longest = 0;
  for (const StringTuning& tuning : tunings)
    for (const int delay : tuning.delay) longest = std::max(longest, delay);
  return longest;
}

}  // namespace

LongitudinalString::LongitudinalString(const StringModel& model, double sample_rate, dsp::LaneWidth width)
    : kernel_(string_kernel(width)), guided_samples_(model.guided_s * sample_rate) {
  for (int rods = 1; rods <= kMaxRods; ++rods) tunings_.push_back(tune_string(model, rods, sample_rate));
  stride_ = longest_delay(tunings_) + kBehind + kSlack;
  memory_.assign(static_cast<std::size_t>(stride_) * kMaxLines, 0.0);
  place_lines();
  restring(model.rods);
}

LongitudinalString::LongitudinalString(const LongitudinalString& other)
    : kernel_(other.kernel_),
      tunings_(other.tunings_),
      memory_(other.memory_),
      stride_(other.stride_),
      guided_samples_(other.guided_samples_),
      contact_(other.contact_),
      rods_(other.rods_),
      block_(other.block_),
      sleeve_impedance_(other.sleeve_impedance_),
      state_(other.state_),
      bit_(other.bit_) {
  place_lines();
}

LongitudinalString& LongitudinalString::operator=(const LongitudinalString& other) noexcept {
  if (this == &other) return *this;
  std::copy(other.memory_.begin(), other.memory_.end(), memory_.begin());
  contact_ = other.contact_;
  rods_ = other.rods_;
  block_ = other.block_;
  sleeve_impedance_ = other.sleeve_impedance_;
  state_ = other.state_;
  bit_ = other.bit_;
  place_lines();
  return *this;
}

void LongitudinalString::place_lines() noexcept {
  for (int j = 0; j < kMaxLines; ++j) state_.line[j] = memory_.data() + j * stride_;
}

void LongitudinalString::restring(int rods) noexcept {
  rods_ = rods;
  const StringTuning& tuning = tunings_[rods - 1];
  state_.joints = tuning.joints;
  state_.cut = -1;
  std::copy(std::begin(tuning.delay), std::end(tuning.delay), state_.delay);
  state_.at = stride_ - kSlack;
  state_.sleeve_steps = tuning.sleeve_steps;
  state_.has_taps = tuning.has_fractions;
  for (int j = 0; j < kMaxLines; ++j) {
    const Lagrange taps = lagrange(tuning.fraction[j]);
    std::copy(std::begin(taps.tap), std::end(taps.tap), state_.tap[j]);
  }
  state_.rho = tuning.reflection();
  place_losses();
  const auto [a1, a2] = thiran(tuning.head_delay);
  state_.a1 = a1, state_.a2 = a2;
  block_ = tuning.block;
  sleeve_impedance_ = tuning.sleeve_impedance;
  silence();
}

void LongitudinalString::set_contact(double contact) noexcept {
  if (contact == contact_) return;
  contact_ = contact;
  place_losses();
}

void LongitudinalString::place_losses() noexcept {
  const StringTuning& tuning = tunings_[rods_ - 1];
  const double held = dsp::exp(-3 * dsp::kLn10 * contact_ * tuning.round_trip() / guided_samples_);
  state_.loss_middle = tuning.loss_middle * held, state_.loss_side = tuning.loss_side * held;
}

void LongitudinalString::part() noexcept {
  if (state_.joints > 0) state_.cut = state_.joints / 2;
}

void LongitudinalString::make_room() noexcept {
  if (state_.at + kChunk <= stride_) return;
  const int kept = stride_ - kSlack;
  for (int j = 0; j <= state_.joints; ++j)
    std::memmove(state_.line[j], state_.line[j] + state_.at - kept,
                 static_cast<std::size_t>(kept) * sizeof(double));
  state_.at = kept;
}

void LongitudinalString::process(const LinesDrive& drive) noexcept {
  make_room();
  for (int from = 0; from < kChunk; from += block_) {
    kernel_.lines(state_, drive, from, block_);
    bit_.process(state_.down, state_.line[state_.joints] + state_.at + from, block_);
  }
  state_.at += kChunk;
}

namespace {

/// What an interpolator still gives and loses when nothing follows its last two inputs; it loses
/// 1 - |H|^2 = |q (1 - 2 z^-1 + z^-2)|^2, q^2 = fraction^2 (1 - fraction^2) / 4.
double interpolator_energy(const double* tap, double u_1, double u_2) noexcept {
  const double d = tap[2] - tap[0], q2 = d * d * (1 - d * d) / 4;
  const double next = tap[1] * u_1 + tap[2] * u_2, last = tap[2] * u_1, lost = u_2 - 2 * u_1;
  return next * next + last * last + q2 * (lost * lost + u_1 * u_1);
}

}  // namespace

double LongitudinalString::energy() const noexcept {
  const LinesState& s = state_;
  // What is left in the allpass: solves E(s') + y^2 = E(s) + u^2.
  const double ratio = s.a1 / (1 + s.a2), share = (1 - s.a2) * ((1 + s.a2) - s.a1 * ratio);
  double sum = bit_.energy() + (s.s1 * s.s1 + s.s2 * s.s2 - 2 * ratio * s.s1 * s.s2) / share;
  for (int j = 0; j <= s.joints; ++j)
    for (int d = 1; d <= s.delay[j]; ++d) sum += s.line[j][s.at - d] * s.line[j][s.at - d];
  // A filter of three taps that add up to 1 keeps what its last two inputs may still give.
  const double side = s.loss_side / (s.loss_middle + 2 * s.loss_side);
  const double* const gone = s.line[0] + s.at - s.delay[0];
  sum += (1 - side) * gone[-1] * gone[-1] + side * gone[-2] * gone[-2];
  for (int j = 1; s.has_taps && j <= s.joints; ++j) {
    const double* const out = s.line[j] + s.at - s.delay[j];
    sum += interpolator_energy(s.tap[j], out[-1], out[-2]);
  }
  for (int j = 0; j < s.joints; ++j)
    for (int i = 0; i < s.sleeve_steps * kSleeveStep; ++i)
      sum += s.sleeve[j][i] * s.sleeve[j][i] / sleeve_impedance_;
  return sum;
}

void LongitudinalString::silence() noexcept {
  std::fill(memory_.begin(), memory_.end(), 0.0);
  std::memset(state_.sleeve, 0, sizeof state_.sleeve);
  state_.s1 = state_.s2 = 0;
  bit_.silence();
}

}  // namespace rigsound::string
