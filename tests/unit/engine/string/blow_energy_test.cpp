// What a joint and a rock leave of a blow, against waves added up and the bit's equation integrated here.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "rigsound/string_model.hpp"

using namespace rigsound;

namespace {

double hann(double share) { return share <= 0 || share >= 1 ? 0 : (1 - std::cos(2 * M_PI * share)) / 2; }

/// A pulse through a sleeve: what goes straight on, and every echo between its two ends.
double energy_through(double impedance, double length_m, double width_s) {
  const double rho = (impedance - 1) / (impedance + 1), step = width_s / 2000;
  double sent = 0, through = 0;
  for (double t = 0; t < 12 * width_s; t += step) {
    double wave = 0, echo = 1 - rho * rho;
    for (int n = 0; n < 200; ++n, echo *= rho * rho)
      wave += echo * hann((t - 2 * n * length_m / 5200) / width_s);
    sent += hann(t / width_s) * hann(t / width_s), through += wave * wave;
  }
  return through / sent;
}

/// The bit's force F: T F' = 2 F_i - F while it loads the rock, F = 2 F_i while the stiff rock lets go.
double energy_back(double width_s, double loading_s) {
  const double step = width_s / 100000;
  double force = 0, sent = 0, back = 0;
  for (double t = 0; t < width_s; t += step) {
    const double in = hann(t / width_s);
    force = 2 * in > force ? force + step / loading_s * (2 * in - force) : 2 * in;
    sent += in * in, back += (force - in) * (force - in);
  }
  return back / sent;
}

}  // namespace

TEST_CASE("a joint lets through what is left when the echoes of its sleeve are added up") {
  for (const double impedance : {1.0, 1.2, 1.6, 2.5})
    for (const double length_m : {0.15, 0.25}) {
      CAPTURE(impedance);
      CAPTURE(length_m);
      StringModel model;
      model.sleeve_impedance = impedance, model.sleeve_length_m = length_m;
      CHECK(joint_transmission(model) ==
            doctest::Approx(energy_through(impedance, length_m, model.strike_width_s)).epsilon(1e-4));
    }
}

TEST_CASE("the energy of a blow passes until rock and guides have taken it") {
  const StringModel model;
  const double round_trip_s = 2 * (model.shank_length_m + model.rod_length_m) / 5200;
  const double kept = std::pow(10, -6 * round_trip_s / model.guided_s);
  for (const double stiffness : {5e7, 2e8, 5e8, 1e9}) {
    CAPTURE(stiffness);
    const double back = energy_back(model.strike_width_s, loading_time_s(model, stiffness));
    CHECK(energy_passes(model, stiffness) == doctest::Approx(1 / (1 - kept * back)).epsilon(0.01));
  }
  // Hardly any rock: all comes back, and only the guides take anything.
  CHECK(energy_passes(model, 1) == doctest::Approx(1 / (1 - kept)).epsilon(1e-3));
}
