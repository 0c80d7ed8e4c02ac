#include "rigsound/analysis/string_figures.hpp"

#include <cmath>

#include "spectrum/stft.hpp"

namespace rigsound::analysis {
namespace {

std::vector<StringMode> of_family(const std::vector<StringMode>& modes, std::string_view family) {
  std::vector<StringMode> found;
  for (const StringMode& mode : modes)
    if (mode.family == family) found.push_back(mode);
  return found;
}

StringModel without_joints(StringModel model) {
  model.shank_length_m = 0;
  model.sleeve_impedance = 1;
  return model;
}

/// Pulses are whole samples long, so x comes near its round numbers but not upon them.
std::vector<ReflectionRow> reflection_rows(double loading_samples, double sample_rate) {
  std::vector<ReflectionRow> rows;
  std::size_t before = 0;
  for (double wanted = 0.1; wanted < 5.05; wanted += wanted < 1.95 ? 0.1 : 0.25) {
    const auto samples = static_cast<std::size_t>(std::lround(wanted * loading_samples));
    if (samples == before) continue;
    before = samples;
    const double x = static_cast<double>(samples) / loading_samples;
    rows.push_back({static_cast<double>(samples) / sample_rate, x, reflected_energy(x),
                    played_reflection(std::vector<double>(samples, 1.0), loading_samples)});
  }
  return rows;
}

/// A Hann pulse of length w has the impulse w / 2 and the energy 3 w / 8.
void add_blow(const StringModel& model, double sample_rate, StringFigures& figures) {
  constexpr double kRectangular = 2.0 / 3;
  const Eigen::ArrayXd pulse =
      hann(static_cast<int>(std::lround(model.strike_width_s * sample_rate)) + 1).cast<double>();
  figures.blow_x = kRectangular * model.strike_width_s / figures.loading_s;
  figures.blow = played_reflection({pulse.begin(), pulse.end()}, figures.loading_s * sample_rate);
}

}  // namespace

StringFigures string_figures(const StringModel& model, double exposed_m, double stiffness_n_per_m,
                             double sample_rate) {
  StringFigures figures;
  const std::vector<StringMode> modes = string_modes(model, exposed_m, sample_rate);
  figures.string = of_family(modes, "longitudinal");
  figures.bending = of_family(modes, "bending");
  figures.rods = of_family(string_modes(without_joints(model), exposed_m, sample_rate), "longitudinal");
  figures.loading_s = loading_time_s(model, stiffness_n_per_m);
  figures.reflection = reflection_rows(figures.loading_s * sample_rate, sample_rate);
  add_blow(model, sample_rate, figures);
  return figures;
}

}  // namespace rigsound::analysis
