#include "rigsound/bank_player.hpp"

#include <algorithm>

#include "drill/click_player.hpp"
#include "impact/impact_train.hpp"

namespace rigsound {

struct BankPlayer::Parts {
  Parts(const ClickBank& b, std::uint64_t seed) : bank(b), train(seed, 0), player(seed, 0, 0) {}
  ClickBank bank;
  impact::ImpactTrain train;
  drill::ClickPlayer player;
};

BankPlayer::BankPlayer(const ClickBank& bank, std::uint64_t seed) {
  require_valid(bank);
  parts_ = std::make_unique<Parts>(bank, seed);
}
BankPlayer::~BankPlayer() = default;
BankPlayer::BankPlayer(BankPlayer&&) noexcept = default;
BankPlayer& BankPlayer::operator=(BankPlayer&&) noexcept = default;

void BankPlayer::process(const DrillControls& controls, double* out) noexcept {
  Parts& p = *parts_;
  p.train.process(impact::statistics_of(p.bank, p.bank.sample_rate, 0, controls));
  for (const Impact& impact : p.train.impacts()) p.player.strike(p.bank, impact, controls);
  std::fill(out, out + kChunk, 0.0);
  p.player.add_to(out);
}

Impacts BankPlayer::impacts() const noexcept { return parts_->train.impacts(); }

}  // namespace rigsound
