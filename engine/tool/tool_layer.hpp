// The ringing bar of one boom: blows in, the sound of the steel out (jackhammer paper, figure 1).
#pragma once

#include <array>
#include <vector>

#include "rigsound/dsp/biquad.hpp"
#include "rigsound/impact.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/tool_model.hpp"
#include "tool/bar_loops.hpp"
#include "tool/contact.hpp"
#include "tool/ramped_curve.hpp"
#include "tool/strikes.hpp"
#include "tool/tool_input.hpp"

namespace rigsound::tool {

class ToolLayer {
 public:
  /// Designs the tool's steels for this rate. Throws std::invalid_argument, naming the key, when the model
  /// makes no sense. Thread: OFF.
  ToolLayer(const ToolModel& model, double sample_rate, std::uint64_t seed, int boom,
            dsp::LaneWidth width = dsp::widest_lanes());

  /// The next kChunk samples, struck by `impacts`; false: all of them are zero. Thread: RT.
  bool process(const ToolInput& input, const Impacts& impacts, double* out) noexcept;

  void reset() noexcept;  ///< to silence. Thread: RT

  /// Another steel (a rod changed, a worn bit): both ring through a crossfade of 20 ms. Called during one,
  /// it waits its turn; the last call wins. `design` must come from design_tool() at this layer's rate.
  /// Thread: RT.
  void change(const ToolDesign& design) noexcept;

 private:
  /// A steel with the hand that damps it.
  struct Steel {
    BarLoops loops;
    Contact contact;
    std::array<double, kChunk> k_L;  ///< the longitudinal reflection, which nothing moves but the controls
  };

  double weight_T() const noexcept { return model_.voicing.level * model_.voicing.transversal_mix; }
  double weight_L() const noexcept { return model_.voicing.level * model_.voicing.longitudinal_mix; }
  Steel steel_of(const ToolDesign& design) const noexcept;
  void follow_rods(int rods) noexcept;
  void begin_fade() noexcept;
  void follow(const ToolInput& input) noexcept;
  void strike(const Impacts& impacts, double period) noexcept;
  void ring(Steel& steel, double* out) noexcept;
  void crossfade(double* out) noexcept;
  void equalise(double* out) noexcept;
  bool rests() const noexcept;

  ToolModel model_;
  double sample_rate_;
  dsp::LaneWidth width_;
  std::vector<ToolDesign> designs_;  ///< of model_.bar, then of model_.rods
  std::size_t chosen_ = 0;           ///< the one the rods ask for
  ToolDesign wanted_;                ///< what change() asked for
  bool change_waits_ = false;

  Strikes strikes_;
  std::vector<Steel> steels_;  ///< two: the one that rings and the one it fades to
  std::size_t ringing_ = 0;
  double fade_ = 0, fade_step_;        ///< share of the crossfade done; 0: none under way
  RampedCurve amplitude_, k_T_, k_L_;  ///< factors
  RampedCurve mix_T_, mix_L_;          ///< weights
  double x_[kChunk];                   ///< excitation of the chunk
  BarDrive drive_;
  std::vector<dsp::Biquad> equaliser_;
};

}  // namespace rigsound::tool
