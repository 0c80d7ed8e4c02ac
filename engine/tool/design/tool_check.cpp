#include <algorithm>
#include <stdexcept>
#include <vector>

#include "rigsound/machine/limits.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound {
namespace {

/// NaN fails every comparison, so it is refused everywhere.
void require(bool fine, const char* complaint) {
  if (!fine) throw std::invalid_argument(complaint);
}

bool between(double value, double low, double high) { return value >= low && value <= high; }

void check_bar(const Bar& bar) {
  require(between(bar.length_m, 0.2, 1.2), "length_m: out of range, expected 0.2...1.2 m");
  require(between(bar.diameter_m, 0.010, 0.080), "diameter_m: out of range, expected 0.010...0.080 m");
  require(bar.diameter_m <= bar.length_m / 4,
          "diameter_m: too thick for its length, expected at most a quarter of length_m");
}

void check_decay(const Decay& decay, double sample_rate) {
  require(between(decay.reflection_max, 0.01, 0.9999), "k_max: out of range, expected 0.01...0.9999");
  require(between(decay.reflection_min, 0.01, decay.reflection_max),
          "k_min: out of range, expected 0.01...k_max");
  require(between(decay.shelf_gain, 0, 1), "shelf_gain: out of range, expected 0...1");
  require(between(decay.shelf_hz, 100, 0.45 * sample_rate),
          "shelf_hz: out of range, expected 100 Hz...0.45 of the sample rate");
  const DecayWish& wish = decay.wish;
  if (wish.low_s == 0 && wish.high_s == 0) return;
  require(
      between(wish.low_hz, 50, 18000) && between(wish.high_hz, 1.1 * wish.low_hz, 0.41 * sample_rate),
      "t60: frequencies out of range, expected 50 Hz <= low_hz < high_hz / 1.1, high_hz <= 0.41 of the rate");
  require(between(wish.low_s, 0.001, 30) && between(wish.high_s, 0.001, 30),
          "t60: times out of range, expected 0.001...30 s");
}

void check_strike(const Strike& s) {
  require(between(s.width_s, 20e-6, 5e-3), "width_s: out of range, expected 0.00002...0.005 s");
  require(between(s.amplitude_variation, 0, 1), "amplitude_variation: out of range, expected 0...1");
  require(s.bounces >= 0 && s.bounces <= kMaxBounces, "bounces: out of range, expected 0...4");
  require(between(s.gap_min, 0.01, s.gap_max) && s.gap_max <= 0.2,
          "gap_min, gap_max: out of range, expected 0.01 <= gap_min <= gap_max <= 0.2");
  require(between(s.ratio_min, 0, s.ratio_max) && s.ratio_max <= 1,
          "ratio_min, ratio_max: out of range, expected 0 <= ratio_min <= ratio_max <= 1");
  require(between(s.fall_s, 1e-4, 1) && between(s.rise_s, 1e-4, 1),
          "fall_s, rise_s: out of range, expected 0.0001...1 s");
  require(between(s.slope_variation, 0, 0.9), "slope_variation: out of range, expected 0...0.9");
}

void check_voicing(const ToolVoicing& v, double sample_rate) {
  require(between(v.transversal_mix, 0, 10) && between(v.longitudinal_mix, 0, 10),
          "mix_T, mix_L: out of range, expected 0...10");
  require(between(v.level, 0, 10), "level: out of range, expected 0...10");
  require(between(v.highpass_hz, 10, 8000), "highpass_hz: out of range, expected 10...8000 Hz");
  require(v.equaliser.size() <= kMaxToolBands, "equaliser: too many bands, expected at most 6");
  for (const ToolBand& band : v.equaliser)
    require(between(band.frequency_hz, 20, 0.45 * sample_rate) && between(band.gain_db, -36, 36) &&
                between(band.q, 0.1, 20),
            "equaliser: band out of range, expected 20 Hz...0.45 of the rate, -36...36 dB, q 0.1...20");
}

void check_rods(const std::vector<RodSteel>& rods) {
  require(rods.size() <= 20, "rods: too many steels, expected at most 20");
  for (const RodSteel& rod : rods) {
    require(rod.rods >= 1 && rod.rods <= 20, "rods: count out of range, expected 1...20");
    check_bar(rod.bar);
  }
}

void check_paper(const ToolModel& model) {
  require(model.paper.M >= 1 && model.paper.M <= kMaxPaperSections, "M: out of range, expected 1...64");
  require(between(model.paper.lambda, -0.999, -0.001), "lambda: out of range, expected -0.999...-0.001");
  require(between(model.paper.N_T, 1, kMaxLoopDelay), "N_T: out of range, expected 1...1000");
  require(between(model.paper.N_L, 1, kMaxLoopDelay), "N_L: out of range, expected 1...1000");
  require(model.transversal.wish.low_s == 0 && model.longitudinal.wish.low_s == 0,
          "t60: not with the paper's model, expected k_min and k_max");
}

void check_loop(const LoopDesign& loop, int most_stages) {
  const Allpass& a = loop.allpass;
  require(a.sections >= 0 && a.first_orders >= 0 && a.first_orders <= 1 && a.stages() <= most_stages,
          "design: too many sections for its loop");
  require(loop.delay_samples >= std::max(1, a.stages()) && loop.delay_samples <= kMaxLoopDelay,
          "design: N out of range, expected the number of sections...1000");
  for (int i = 0; i < a.sections; ++i) {
    const auto [b, c] = a.section[static_cast<std::size_t>(i)];
    require(between(b, 1e-12, 1e6) && between(c, 1e-12, 1e6),
            "design: section out of range, expected b, c > 0");
  }
  require(between(a.a, 1e-12, 1e6), "design: first-order section out of range, expected a > 0");
  require(between(loop.filters.dc, 1e-6, 1) && between(loop.filters.shelf, 1e-6, 1e3) &&
              between(loop.filters.shelf_gain, 0, 1),
          "design: filter out of range");
  require(between(loop.reflection_max, 0, 0.9999) && between(loop.reflection_min, 0, loop.reflection_max),
          "design: k out of range, expected 0 <= k_min <= k_max <= 0.9999");
}

}  // namespace

void require_valid(const ToolModel& model, double sample_rate) {
  require(between(sample_rate, kMinSampleRate, kMaxSampleRate),
          "rate: out of range, expected 32000...192000 Hz");
  check_bar(model.bar);
  check_decay(model.transversal, sample_rate);
  check_decay(model.longitudinal, sample_rate);
  check_strike(model.strike);
  check_voicing(model.voicing, sample_rate);
  check_rods(model.rods);
  if (model.kind == ToolKind::kPaper) check_paper(model);
  for (const ToolDesign& design : model.designs) require_valid(design);
}

void require_valid(const ToolDesign& design) {
  check_loop(design.transversal, kMaxSections);
  check_loop(design.longitudinal, kMaxLongSections);
}

}  // namespace rigsound
