#include "bank_sounds.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "sound_set_json.hpp"

namespace rigsound::studio {

BankSound bank_sound(Workplace& place, const std::string& bank, const std::string& which, double most_s) {
  constexpr int kRate = static_cast<int>(analysis::kAnalysisRate);
  const config::StoredBank played = config::load_bank(bank_folder(place, bank));
  const auto most = static_cast<std::size_t>(most_s * kRate);
  std::shared_ptr<const analysis::RecordedSide> side;
  try {
    side = place.comparisons.of(played);
  } catch (const ApiError&) {
    if (which != "synthesised") throw;
  }
  const auto beginning = [&](const std::vector<float>& x) {
    return BankSound{{x.begin(), x.begin() + static_cast<long>(std::min(most, x.size()))}, kRate};
  };
  if (which == "recorded") return beginning(side->recorded);
  if (which == "denoised") return beginning(side->denoised);
  if (which != "synthesised") throw ApiError(404, "expected recorded, denoised or synthesised");
  const std::size_t length = side ? std::min(most, side->recorded.size()) : 0;
  const double seconds = side ? static_cast<double>(length) / kRate : std::min(kSynthesis_s, most_s);
  BankSound sound{analysis::resynthesise(played.bank, seconds, kSynthesisSeed).sound,
                  static_cast<int>(std::lround(played.bank.sample_rate))};
  if (side && played.bank.sample_rate == kRate) sound.samples.resize(length);
  return sound;
}

}  // namespace rigsound::studio
