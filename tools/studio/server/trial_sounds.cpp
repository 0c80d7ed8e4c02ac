#include "trial_sounds.hpp"

#include <algorithm>
#include <cmath>

#include "bank_sounds.hpp"
#include "rigsound/analysis/blind_sounds.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/wave_file.hpp"

namespace rigsound::studio {
namespace {

constexpr double kShortest_s = 0.5;
constexpr int kTrialRate = static_cast<int>(analysis::kAnalysisRate);

std::size_t at_trial_rate(double seconds) {
  return static_cast<std::size_t>(std::llround(seconds * kTrialRate));
}

/// Before the excerpt is cut out of it.
std::vector<float> whole(Workplace& place, const TrialRequest& request, const std::string& kind) {
  const bool anchor = kind == "anchor";
  BankSound sound =
      bank_sound(place, request.bank, anchor ? "recorded" : kind, request.from_s + request.seconds);
  if (sound.rate != kTrialRate) throw ApiError(422, request.bank + ": is not at 48 kHz");
  return anchor ? analysis::low_anchor(sound.samples) : sound.samples;
}

}  // namespace

const std::vector<std::string>& trial_kinds() {
  static const std::vector<std::string> kinds = {"recorded", "denoised", "synthesised", "anchor"};
  return kinds;
}

TrialSounds trial_sounds(Workplace& place, const TrialRequest& request) {
  std::vector<std::vector<float>> sounds;
  std::size_t length = at_trial_rate(request.seconds);
  const std::size_t from = at_trial_rate(request.from_s);
  for (const std::string& kind : request.kinds) {
    sounds.push_back(whole(place, request, kind));
    length = std::min(length, sounds.back().size() - std::min(from, sounds.back().size()));
  }
  if (length < at_trial_rate(kShortest_s)) throw ApiError(400, "from_s: the recorded part ends before");
  for (std::vector<float>& sound : sounds) sound = analysis::excerpt(sound, from, length);
  const std::vector<double> gains_db = analysis::matching_gains_db(sounds);
  TrialSounds made;
  made.seconds = static_cast<double>(length) / kTrialRate;
  for (std::size_t i = 0; i < sounds.size(); ++i) {
    const auto gain = static_cast<float>(std::pow(10, gains_db[i] / 20));
    for (float& value : sounds[i]) value *= gain;
    made.waves[request.kinds[i]] = analysis::wave_bytes(sounds[i], kTrialRate);
    made.gains_db[request.kinds[i]] = gains_db[i];
  }
  return made;
}

}  // namespace rigsound::studio
