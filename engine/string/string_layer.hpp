// The drill string of one boom: blows in, the sound of its rods out.
#pragma once

#include <cstdint>

#include "rigsound/impact.hpp"
#include "rigsound/string_model.hpp"
#include "string/bending_modes.hpp"
#include "string/longitudinal_string.hpp"
#include "string/string_input.hpp"
#include "tool/strikes.hpp"

namespace rigsound::string {

class StringLayer {
 public:
  /// Throws std::invalid_argument, naming the key, when the model makes no sense. Thread: OFF.
  StringLayer(const StringModel& model, double sample_rate, std::uint64_t seed, int boom,
              dsp::LaneWidth width = dsp::widest_lanes());

  /// The next kChunk samples, struck by `impacts`; false: all of them are zero. Thread: RT.
  bool process(const StringInput& input, const Impacts& impacts, double* out) noexcept;

  void reset() noexcept;  ///< to silence. Thread: RT

 private:
  enum class Fade { kNone, kOut, kIn };

  void change_string(const StringInput& input) noexcept;
  void restring(const StringInput& input) noexcept;
  void break_rod() noexcept;
  void follow(const StringInput& input) noexcept;
  void ring(bool struck, double* out) noexcept;
  void apply_fade(double* out) noexcept;
  void rest_if_silent(bool struck, const double* out) noexcept;
  void fall_asleep() noexcept;

  StringModel model_;
  double impedance_;                                               ///< of the rod, times samples a second
  double width_samples_;                                           ///< of a strike
  double contact_step_, loading_left_, exposed_left_, fade_step_;  ///< a chunk, a chunk, a chunk, a sample
  StringKernel kernel_;
  tool::Strikes strikes_;
  LongitudinalString string_;
  BendingModes bending_;

  int rods_;
  double exposed_m_, contact_ = 0;
  double loading_samples_;
  bool broken_ = false;
  Fade fade_ = Fade::kNone;
  double gain_ = 1;  ///< of the fade, before smoothstep

  double x_[kChunk];          ///< strikes of the chunk
  double snap_[kChunk] = {};  ///< and the pulse of a breaking rod
  bool snaps_ = false;
  double snap_pulse_[kChunk] = {};
  VoiceState voice_{};
  bool asleep_ = true;
  int quiet_ = 0;  ///< chunks
};

}  // namespace rigsound::string
