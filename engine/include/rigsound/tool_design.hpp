// The loops designed for one steel at one sample rate: plain data, small enough to hand to the audio thread.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rigsound/steel.hpp"

namespace rigsound {

struct ToolModel;

constexpr int kMaxSections = 20;       ///< second-order allpass sections of a transversal loop
constexpr int kMaxLongSections = 4;    ///< and of a longitudinal one, a first-order section counted
constexpr int kMaxPaperSections = 64;  ///< first-order sections of the paper's own loop
constexpr int kMaxLoopDelay = 1000;    ///< samples
constexpr int kMaxBounces = 4;
constexpr int kMaxToolBands = 6;
constexpr int kMaxRodSteels = 20;

/// (p^2 - b p + c) / (p^2 + b p + c) with p = (1 - z^-1) / (1 + z^-1); stable for all b, c > 0.
struct AllpassSection {
  double b = 0, c = 0;
};

/// Dispersion of a loop: second-order sections and `first_orders` equal sections (a - p) / (a + p).
struct Allpass {
  int sections = 0;
  std::array<AllpassSection, kMaxSections> section{};
  int first_orders = 0;  ///< 0 or 1 in a designed loop, M in the paper's
  double a = 1;

  int order() const noexcept { return 2 * sections + first_orders; }
  int stages() const noexcept { return sections + first_orders; }
};

/// What a loop does to a wave besides delaying it: DC blocker p / (p + dc), shelf (s + g p) / (s + p).
struct LoopFilters {
  double dc = 0;          ///< sqrt 3 tan(pi 20 Hz / rate): -6.02 dB at 20 Hz
  double shelf = 1;       ///< tan(pi corner / rate)
  double shelf_gain = 1;  ///< g: gain above the corner
};

template <class Archive>
void fields(Archive& a, LoopFilters& o) {
  a("dc", o.dc, Range{1e-6, 1});
  a("shelf", o.shelf, Range{1e-6, 1e3});
  a("g", o.shelf_gain, Range{0, 1});
}

/// y = x + k v, v = shelf(dc(allpass(z^-N y))).
struct LoopDesign {
  int delay_samples = 0;  ///< N: delay line, samples; at least allpass.stages()
  Allpass allpass;
  LoopFilters filters;
  double reflection_min = 0, reflection_max = 0;  ///< k: in contact, and free
};

template <class Archive>
void fields(Archive& a, LoopDesign& o) {
  constexpr Range kReflections{0, 0.9999};
  a("N", o.delay_samples, Range{1, kMaxLoopDelay, "samples"});
  a("allpass", o.allpass, Range{1e-12, 1e6});  // of each b, c and a
  a("filters", o.filters);
  a("k_min", o.reflection_min, kReflections);
  a("k_max", o.reflection_max, kReflections);
}

/// What a design was made for. When it is no longer what the tool says, the design is out of date.
struct DesignInput {
  Bar bar;
  Decay transversal, longitudinal;
};
bool operator==(const DesignInput& a, const DesignInput& b) noexcept;

template <class Archive>
void fields(Archive& a, DesignInput& o) {
  fields(a, o.bar);
  a("transversal", o.transversal);
  a("longitudinal", o.longitudinal);
}

struct ToolDesign {
  double sample_rate = 0;
  LoopDesign transversal, longitudinal;
  DesignInput made_for;
};

template <class Archive>
void fields(Archive& a, ToolDesign& o) {
  a("rate", o.sample_rate, kSampleRates);
  a("made_for", o.made_for);
  a("transversal", o.transversal);
  a("longitudinal", o.longitudinal);
}

/// One mode below 18 kHz (or 0.41 of the sample rate) as wanted and as the loop's pole has it, both with
/// the reflection half-way between k_min and k_max.
struct TunedMode {
  std::string_view family;  ///< "transversal" or "longitudinal"
  int mode = 1;
  double target_hz = 0, model_hz = 0, error_cents = 0;
  double t60_s = 0;  ///< with k_max, the free tool
};

/// Refuses nonsense, so that nothing can go wrong while the tool plays. Throws InvalidField. Thread: OFF, CT.
void require_valid(const ToolModel& model, double sample_rate);

/// Designs both loops of `model` at `sample_rate` (Hz): milliseconds, the same bits on every machine.
/// A designed tool's poles are within 1 cent of the bar's modes. Throws std::invalid_argument, with one
/// line that names the key, when the model makes no sense. Thread: OFF, CT.
ToolDesign design_tool(const ToolModel& model, double sample_rate);

/// The model's own design for that rate if it brings one that was made for its bar and decays, else a new
/// one. Thread: OFF, CT.
ToolDesign design_for(const ToolModel& model, double sample_rate);

/// The modes of both families of a free-free bar, Hz, rising, below `highest_hz`: exact, no loop involved.
/// Thread: OFF.
std::vector<double> modes_below(const Bar& bar, double highest_hz);

/// Every mode of both families. Thread: OFF, CT.
std::vector<TunedMode> tuned_modes(const ToolModel& model, const ToolDesign& design);

}  // namespace rigsound
