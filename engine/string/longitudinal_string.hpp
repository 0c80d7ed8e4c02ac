// Waves along the string: shank, rods and sleeves down to the bit, and the bit on the rock.
#pragma once

#include <vector>

#include "rigsound/string_model.hpp"
#include "string/bit_contact.hpp"
#include "string/string_kernel.hpp"

namespace rigsound::string {

class LongitudinalString {
 public:
  /// Silent, with the model's rods. Thread: OFF.
  LongitudinalString(const StringModel& model, double sample_rate, dsp::LaneWidth width);

  LongitudinalString(LongitudinalString&&) = default;  // the lines stay where they are
  LongitudinalString(const LongitudinalString& other);
  /// Takes over a string of the same model without allocating. Thread: RT.
  LongitudinalString& operator=(const LongitudinalString& other) noexcept;

  /// Silence, and `rods` 1...kMaxRods from now on, in one piece. Thread: RT.
  void restring(int rods) noexcept;

  /// The string parts in the middle; both parts have free ends there until restring(). Thread: RT.
  void part() noexcept;

  /// 0...1: how hard chuck and guides hold the string. Thread: RT.
  void set_contact(double contact) noexcept;

  /// kChunk samples. Thread: RT.
  void process(const LinesDrive& drive) noexcept;

  BitContact& bit() noexcept { return bit_; }
  bool parted() const noexcept { return state_.cut >= 0; }

  /// In all waves and in the bit's spring; never grows without input.
  double energy() const noexcept;
  void silence() noexcept;

 private:
  void place_lines() noexcept;
  void make_room() noexcept;
  void place_losses() noexcept;

  StringKernel kernel_;
  std::vector<StringTuning> tunings_;  ///< of 1...kMaxRods rods
  std::vector<double> memory_;         ///< of all lines, stride_ each
  int stride_;
  double guided_samples_;  ///< T60
  double contact_ = 0;
  int rods_ = 1;
  int block_ = kSleeveStep;
  double sleeve_impedance_ = 1;
  LinesState state_{};
  BitContact bit_;
};

}  // namespace rigsound::string
