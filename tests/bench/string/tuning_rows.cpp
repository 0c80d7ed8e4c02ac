// Strings of every length: their modes against exact scattering and exact Timoshenko.
#include <algorithm>
#include <cmath>
#include <string>

#include "bench/string/rows.hpp"
#include "bench/tool/row.hpp"
#include "engine/string/string_sounds.hpp"

namespace rigsound::bench {
namespace {

using namespace tests;

double worst_cents(const StringModel& model, double exposed_m, std::string_view family,
                   double lowest_hz = 0) {
  double worst = 0;
  for (const StringMode& mode : string_modes(model, exposed_m, kStringRate))
    if (mode.family == family && mode.target_hz >= lowest_hz)
      worst = std::max(worst, std::fabs(mode.error_cents));
  return worst;
}

/// Over rods of 0.6...6.4 m.
template <class Make>
double worst_comb(int rods, const Make& make) {
  double worst = 0;
  for (double L = 0.6; L <= 6.4; L *= rods == 20 ? 1.2 : 1.02)
    worst = std::max(worst, worst_cents(make(L, rods), L, "longitudinal"));
  return worst;
}

void print_combs() {
  for (const int rods : {1, 6, 20}) {
    const std::string who = std::to_string(rods) + " rods of 0.6...6.4 m: modes below 6 kHz";
    print({who + ", no joints", Bound::kAtMost, 2, worst_comb(rods, bare_string), "cents"});
    for (const double impedance : {1.2, 2.5}) {
      const auto jointed = [&](double L, int N) {
        StringModel model = plain_string(L, 0.025, N);
        model.sleeve_impedance = impedance;
        return model;
      };
      print({who + (impedance < 2 ? ", sleeves Z x 1.2" : ", sleeves Z x 2.5"), Bound::kAtMost,
             impedance < 2 ? 5.0 : 25.0, worst_comb(rods, jointed), "cents"});
    }
  }
}

void print_bending() {
  double worst = 0;
  std::size_t most = 0;
  for (const auto& [L, d] : {std::pair{1.83, 0.032},
                             {3.05, 0.038},
                             {3.66, 0.038},
                             {4.27, 0.045},
                             {6.1, 0.051},
                             {6.4, 0.025},
                             {6.4, 0.076}})
    for (const double share : {1.0, 0.5, 0.25}) {
      const auto exact = timoshenko_modes(L * share, d, 12000);
      std::size_t k = 0;
      most = std::max(most, exact.size());
      for (const StringMode& mode : string_modes(plain_string(L, d), L * share, kStringRate)) {
        if (mode.family != "bending") continue;
        const double error = 1200 * std::log2(mode.model_hz / exact.at(k++));
        if (mode.target_hz > 60) worst = std::max(worst, std::fabs(error));
      }
    }
  print({"bending 60 Hz...12 kHz, 7 rods exposed by L, L/2, L/4", Bound::kAtMost, 2, worst, "cents"});
  print({"bending modes of the rod that has most of them", Bound::kAtLeast, 100, static_cast<double>(most),
         ""});
}

}  // namespace

void print_string_tuning() {
  print_combs();
  print_bending();
  for (const int samples : {9, 16})
    print({"energy sent back at the bit, x 0.25...3, pulses of " + std::to_string(samples) + " samples",
           Bound::kAtMost, 1, 100 * largest_reflection_error(samples), "%"});
}

}  // namespace rigsound::bench
