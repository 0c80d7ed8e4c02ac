#include "drill/bank_check.hpp"

#include <cmath>
#include <stdexcept>

namespace rigsound::drill {
namespace {

void require(bool holds, const ClickBank& bank, const char* what) {
  if (!holds) throw std::invalid_argument("bank \"" + bank.name + "\": " + what);
}

bool between(double x, double low, double high) { return x >= low && x <= high; }

}  // namespace

void require_playable(const ClickBank& bank) {
  require(between(bank.sample_rate, 8000, 192000), bank, "sample_rate must be 8000...192000 Hz");
  require(between(bank.mean_gap_samples, bank.sample_rate / 200, bank.sample_rate), bank,
          "T0 must be a period of 1...200 Hz");
  require(between(bank.gap_deviation_samples, 0, 2 * bank.mean_gap_samples), bank,
          "sigma_T must be 0...2 T0");
  require(bank.mean_amplitude > 0 && between(bank.mean_amplitude, 0, 1e4), bank, "B must be positive");
  require(between(bank.amplitude_deviation, 0, 4 * bank.mean_amplitude), bank, "sigma_B must be 0...4 B");
  require(between(bank.gap_correlation, -0.99, 0.99) && between(bank.amplitude_correlation, -0.99, 0.99),
          bank, "r_T and r_B must be -0.99...0.99");
  require(between(bank.miss_share, 0, 1) && between(bank.double_share, 0, 1 - bank.miss_share), bank,
          "p_miss and p_double must be shares that add up to at most 1");
  require(between(bank.attack_samples, 0, bank.sample_rate) && between(bank.decay, 0, 1) &&
              between(bank.attack_bend, -100, 100),
          bank, "N_a, alpha_a or alpha_d is out of range");
  require(between(bank.gain_db, -60, 60), bank, "gain_db must be -60...60 dB");
  require(!bank.clicks.empty(), bank, "there are no clicks");
  for (const auto& click : bank.clicks) {
    require(!click.empty(), bank, "a click is empty");
    for (const float x : click)
      require(std::fabs(x) <= 1e3f, bank, "a click has a sample that is not finite");
  }
}

}  // namespace rigsound::drill
