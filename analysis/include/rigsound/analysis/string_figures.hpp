// What a drill string rings at and what its bit sends back, as figures and as a picture.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rigsound/string_model.hpp"

namespace rigsound::analysis {

/// A rectangular pulse at the bit.
struct ReflectionRow {
  double pulse_s = 0;
  double x = 0;           ///< its length over the rock's loading time
  double target = 0;      ///< share of its energy sent back, closed form
  BitReflection reached;  ///< as the string plays it
};

struct StringFigures {
  std::vector<StringMode> rods;    ///< longitudinal, of the rods end to end without shank and sleeves: a comb
  std::vector<StringMode> string;  ///< longitudinal, of the string as it is
  std::vector<StringMode> bending;        ///< of the rod outside the hole
  double loading_s = 0;                   ///< how long the bit takes to load the rock
  std::vector<ReflectionRow> reflection;  ///< x rising from about 0.1 to 5
  double blow_x = 0;  ///< of the model's own blow: its length is that of the rectangular pulse with
                      ///< the same impulse and energy
  BitReflection blow;
};

/// `exposed_m` (m) and `sample_rate` (Hz) as string_modes() takes them; `stiffness_n_per_m` of the rock, > 0.
/// Throws std::invalid_argument as string_modes() does. Thread: OFF.
StringFigures string_figures(const StringModel& model, double exposed_m, double stiffness_n_per_m,
                             double sample_rate);

/// An SVG page: error of every mode and its decay over frequency, what the bit sends back over x with the
/// model's blow on it. Thread: OFF.
std::string string_plot_svg(std::string_view title, std::string_view rock, const StringFigures& figures);

}  // namespace rigsound::analysis
