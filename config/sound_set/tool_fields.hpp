// The fields of tools/NAME.json, named once for reading and writing alike. An archive is called with a key
// and a reference: number, integer, nested object, or list of objects.
#pragma once

#include "rigsound/tool_model.hpp"

namespace rigsound::config {

template <class Archive>
void fields(Archive& a, Bar& bar) {
  a("length_m", bar.length_m);
  a("diameter_m", bar.diameter_m);
}

template <class Archive>
void fields(Archive& a, DecayWish& wish) {
  a("low_hz", wish.low_hz);
  a("low_s", wish.low_s);
  a("high_hz", wish.high_hz);
  a("high_s", wish.high_s);
}

template <class Archive>
void fields(Archive& a, Decay& decay) {
  a("k_min", decay.reflection_min);
  a("k_max", decay.reflection_max);
  a("shelf_gain", decay.shelf_gain);
  a("shelf_hz", decay.shelf_hz);
  a("t60", decay.wish);
}

template <class Archive>
void fields(Archive& a, Strike& strike) {
  a("width_s", strike.width_s);
  a("amplitude_variation", strike.amplitude_variation);
  a("bounces", strike.bounces);
  a("gap_min", strike.gap_min);
  a("gap_max", strike.gap_max);
  a("ratio_min", strike.ratio_min);
  a("ratio_max", strike.ratio_max);
  a("fall_s", strike.fall_s);
  a("rise_s", strike.rise_s);
  a("slope_variation", strike.slope_variation);
}

template <class Archive>
void fields(Archive& a, ToolBand& band) {
  a("frequency_hz", band.frequency_hz);
  a("gain_db", band.gain_db);
  a("q", band.q);
}

template <class Archive>
void fields(Archive& a, ToolVoicing& voicing) {
  a("mix_T", voicing.transversal_mix);
  a("mix_L", voicing.longitudinal_mix);
  a("highpass_hz", voicing.highpass_hz);
  a("level", voicing.level);
  a("equaliser", voicing.equaliser);
}

template <class Archive>
void fields(Archive& a, PaperLoops& paper) {
  a("M", paper.M);
  a("lambda", paper.lambda);
  a("N_T", paper.N_T);
  a("N_L", paper.N_L);
}

template <class Archive>
void fields(Archive& a, RodSteel& rod) {
  a("rods", rod.rods);
  fields(a, rod.bar);
}

template <class Archive>
void fields(Archive& a, LoopFilters& filters) {
  a("dc", filters.dc);
  a("shelf", filters.shelf);
  a("g", filters.shelf_gain);
}

template <class Archive>
void fields(Archive& a, LoopDesign& loop) {
  a("N", loop.delay_samples);
  a("allpass", loop.allpass);
  a("filters", loop.filters);
  a("k_min", loop.reflection_min);
  a("k_max", loop.reflection_max);
}

template <class Archive>
void fields(Archive& a, DesignInput& input) {
  fields(a, input.bar);
  a("transversal", input.transversal);
  a("longitudinal", input.longitudinal);
}

template <class Archive>
void fields(Archive& a, ToolDesign& design) {
  a("rate", design.sample_rate);
  a("made_for", design.made_for);
  a("transversal", design.transversal);
  a("longitudinal", design.longitudinal);
}

template <class Archive>
void fields(Archive& a, ToolModel& tool) {
  a("model", tool.kind);
  fields(a, tool.bar);
  a("transversal", tool.transversal);
  a("longitudinal", tool.longitudinal);
  a("strike", tool.strike);
  a("voicing", tool.voicing);
  a("paper", tool.paper);
  a("rods", tool.rods);
  a("designs", tool.designs);
}

}  // namespace rigsound::config
