#include <algorithm>
#include <vector>

#include "field_check.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound {
namespace {

constexpr double kThickestBar = 0.25;  // diameter, as a share of the length
constexpr double kWishDistance = 1.1;  // between the two frequencies of a wanted decay

std::string corner_name() { return number_text(kHighestCorner) + " of the sample rate"; }

void require_bar(const FieldCheck& check, const Bar& bar) {
  check.require(
      bar.diameter_m <= kThickestBar * bar.length_m, "diameter_m",
      "is " + number_text(bar.diameter_m) + " m, too thick, expected at most a quarter of length_m");
}

void require_wish(const FieldCheck& check, const DecayWish& wish, double sample_rate) {
  if (wish.low_s == 0 && wish.high_s == 0) return;
  check.require(wish.low_hz > 0 && wish.low_s > 0 && wish.high_hz > 0 && wish.high_s > 0, "t60",
                "is given in part, expected low_hz, low_s, high_hz and high_s, or none of them");
  check.require(wish.high_hz >= kWishDistance * wish.low_hz, "t60",
                "has its frequencies too close together, expected high_hz at least " +
                    number_text(kWishDistance) + " low_hz");
  check.at_most(kHighestMode * sample_rate, number_text(kHighestMode) + " of the sample rate", wish.high_hz,
                "t60.high_hz");
}

void require_decay(const FieldCheck& check, const Decay& decay, double sample_rate) {
  check.at_most(decay.reflection_max, "k_max", decay.reflection_min, "k_min");
  check.at_most(kHighestCorner * sample_rate, corner_name(), decay.shelf_hz, "shelf_hz");
  require_wish(check, decay.wish, sample_rate);
}

void require_bands(const FieldCheck& check, const std::vector<ToolBand>& bands, double sample_rate) {
  check.require(
      bands.size() <= kMaxToolBands, "equaliser",
      "has " + std::to_string(bands.size()) + " bands, expected at most " + std::to_string(kMaxToolBands));
  for (std::size_t i = 0; i < bands.size(); ++i)
    check.inside("equaliser", i)
        .at_most(kHighestCorner * sample_rate, corner_name(), bands[i].frequency_hz, "frequency_hz");
}

void require_rods(const FieldCheck& check, const std::vector<RodSteel>& rods) {
  check.require(
      rods.size() <= kMaxRodSteels, "rods",
      "has " + std::to_string(rods.size()) + " steels, expected at most " + std::to_string(kMaxRodSteels));
  for (std::size_t i = 0; i < rods.size(); ++i) require_bar(check.inside("rods", i), rods[i].bar);
}

void require_loop(const FieldCheck& check, const LoopDesign& loop, int most_stages) {
  const Allpass& a = loop.allpass;
  check.require(
      (a.first_orders == 0 || a.first_orders == 1) && a.stages() <= most_stages, "allpass",
      "has " + std::to_string(a.stages()) + " sections, expected at most " + std::to_string(most_stages));
  check.require(loop.delay_samples >= a.stages(), "N",
                "is " + std::to_string(loop.delay_samples) + ", expected at least the number of sections, " +
                    std::to_string(a.stages()));
  check.at_most(loop.reflection_max, "k_max", loop.reflection_min, "k_min");
}

void require_design(const FieldCheck& check, const ToolDesign& design) {
  require_loop(check.inside("transversal"), design.transversal, kMaxSections);
  require_loop(check.inside("longitudinal"), design.longitudinal, kMaxLongSections);
}

}  // namespace

void require_valid(const ToolModel& model, double sample_rate) {
  const FieldCheck check(model.name.empty() ? "" : "tool \"" + model.name + "\": ");
  check("rate", sample_rate, kSampleRates);
  check.ranges(model);
  require_bar(check, model.bar);
  require_decay(check.inside("transversal"), model.transversal, sample_rate);
  require_decay(check.inside("longitudinal"), model.longitudinal, sample_rate);
  check.inside("strike").at_most(model.strike.gap_max, "gap_max", model.strike.gap_min, "gap_min");
  check.inside("strike").at_most(model.strike.ratio_max, "ratio_max", model.strike.ratio_min, "ratio_min");
  require_bands(check.inside("voicing"), model.voicing.equaliser, sample_rate);
  require_rods(check, model.rods);
  if (model.kind == ToolKind::kPaper)
    check.require(model.transversal.wish.low_s == 0 && model.longitudinal.wish.low_s == 0, "t60",
                  "is not for the paper's model, expected k_min and k_max");
  for (std::size_t i = 0; i < model.designs.size(); ++i)
    require_design(check.inside("designs", i), model.designs[i]);
}

}  // namespace rigsound
