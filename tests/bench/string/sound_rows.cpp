// What can be measured in the sound of a string.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/string/rows.hpp"
#include "bench/tool/row.hpp"
#include "engine/string/string_sounds.hpp"

namespace rigsound::bench {
namespace {

using namespace string;
using namespace tests;

StringInput drilling(int rods, double rock, double contact) {
  StringInput input;
  input.rods = rods;
  input.rock_stiffness = rock;
  input.contact = contact;
  return input;
}

void print_energy() {
  double string = -1, bending = -1;
  for (const dsp::LaneWidth width : {dsp::LaneWidth::kTwo, dsp::widest_lanes()})
    for (const double L : {0.6, 1.83, 6.4}) {
      string = std::max(string, largest_string_growth(plain_string(L, 0.038, 3), 20000, width));
      bending = std::max(bending, largest_bending_growth(plain_string(L, 0.038, 3), 20000, width));
    }
  print({"growth of zero-input energy of waves, random k, gap, rods, breaks", Bound::kAtMost, 1e-13, string,
         ""});
  print(
      {"growth of zero-input energy of bending, random length, contact", Bound::kAtMost, 1e-13, bending, ""});
}

/// Least ratio of ringing energies from one feed to the next lower.
void print_feed() {
  for (const double mix : {1.0, 0.0}) {
    double least = 1e9;
    for (const double rock : {5e7, 2e8, 2e9})
      for (const int rods : {1, 6, 20}) {
        StringModel model = plain_string(3.66, 0.038, rods);
        model.bending_mix *= mix;
        double before = 0;
        for (double contact = 1; contact > -0.05; contact -= 0.1) {
          const double energy = ringing_energy(model, drilling(rods, rock, std::max(0.0, contact)));
          if (before > 0) least = std::min(least, 10 * std::log10(energy / before));
          before = energy;
        }
      }
    print({std::string(mix > 0 ? "all of it" : "waves alone") +
               ": more ringing 100 ms after, a tenth less feed",
           Bound::kAtLeast, mix > 0 ? 0.0 : -100.0, least, "dB"});
  }
}

void print_residues() {
  StringModel model = plain_string();
  model.bending_low_s = model.bending_high_s = 30;
  print({"3.66 -> 0.3 m in 60 s while it rings: above 12.6 kHz", Bound::kAtMost, -90,
         gliding_residue_db(model, 3.66, 0.3, 0.056), "dB"});
  double worst = -300;
  for (const int rods : {2, 6, 20}) {
    StringLayer layer(model, kStringRate, 1, 0);
    const auto sound = struck(layer, {1, 0.00101, 100}, [&](double t) {
      StringInput input = drilling(t < 0.5 ? 1 : rods, 2e8, 0);
      input.exposed_m = t < 0.5 ? 0.5 : 3.66;
      return input;
    });
    worst = std::max(worst, residue_above_modes_db(sound, 0.45, 0.6));
  }
  print({"a rod is added while it rings: above 12.6 kHz", Bound::kAtMost, -90, worst, "dB"});
}

std::vector<double> rendered(const StringInput& input, std::uint64_t seed) {
  StringLayer layer(StringModel{}, kStringRate, seed, 0);
  return struck(layer, {20}, [&](double) { return input; });
}

void print_distances() {
  const auto one = rendered(drilling(1, 2e8, 1), 1), again = rendered(drilling(1, 2e8, 1), 2);
  const double floor = third_octave_distance_db(one, again);
  const auto row = [&](const std::string& what, const std::vector<double>& a, const std::vector<double>& b) {
    print({what + ": third-octave distance over two seeds'", Bound::kAtLeast, 2,
           third_octave_distance_db(a, b) / floor, "times"});
  };
  const auto six = rendered(drilling(6, 2e8, 1), 1), twenty = rendered(drilling(20, 2e8, 1), 1);
  row("1 and 6 rods", one, six);
  row("6 and 20 rods", six, twenty);
  row("1 and 20 rods", one, twenty);
  row("soft and hard rock", rendered(drilling(1, 5e7, 1), 1), rendered(drilling(1, 2e9, 1), 1));
  row("full feed and half", one, rendered(drilling(1, 2e8, 0.5), 1));
}

}  // namespace

void print_string_sound() {
  print_energy();
  print_feed();
  print_residues();
  print_distances();
}

}  // namespace rigsound::bench
