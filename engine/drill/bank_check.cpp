#include "field_check.hpp"
#include "rigsound/click_bank.hpp"
#include "rigsound/dsp/energy.hpp"

namespace rigsound {
namespace {

constexpr double kSlowest_hz = 1, kFastest_hz = 200;  // strikes a second
constexpr double kLeastBend = -100;                   // exp(-alpha_a N_a) must be a number
constexpr double kMostEnergy = 1e6;                   // of a unit click: far from it, yet a number

void require_clicks(const FieldCheck& check, const ClickBank& bank) {
  check.require(!bank.clicks.empty(), "clicks", "there are no clicks, expected at least one");
  for (const Click& click : bank.clicks) {
    check.require(!click.empty(), "clicks", "one is empty, expected samples");
    check.require(dsp::energy(click) <= kMostEnergy, "clicks",
                  "one has a sample that is not finite, expected unit clicks");
  }
}

}  // namespace

void require_valid_numbers(const ClickBank& bank) {
  const FieldCheck check("bank \"" + bank.name + "\": ");
  check.ranges(bank);
  const Range gaps{bank.sample_rate / kFastest_hz, bank.sample_rate / kSlowest_hz, "samples"};
  check.require(gaps.holds(bank.mean_gap_samples), "T0", gaps.problem(bank.mean_gap_samples));
  check.at_most(2 * bank.mean_gap_samples, "2 T0", bank.gap_deviation_samples, "sigma_T");
  check.at_most(4 * bank.mean_amplitude, "4 B", bank.amplitude_deviation, "sigma_B");
  check.at_most(1 - bank.miss_share, "1 - p_miss", bank.double_share, "p_double");
  check.at_most(bank.sample_rate, "a second", bank.attack_samples, "N_a");
  const double bend = bank.attack_bend * bank.attack_samples;
  check.require(bend >= kLeastBend, "alpha_a",
                "times N_a is " + number_text(bend) + ", expected at least " + number_text(kLeastBend) +
                    ": no number is as large as the attack's exponential");
}

void require_valid(const ClickBank& bank) {
  require_valid_numbers(bank);
  require_clicks(FieldCheck("bank \"" + bank.name + "\": "), bank);
}

}  // namespace rigsound
