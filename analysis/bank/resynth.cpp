#include "rigsound/analysis/resynth.hpp"

#include <cmath>
#include <stdexcept>

#include "rigsound/bank_player.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

BankPlayer player_of(const ClickBank& bank, std::uint64_t seed) {
  try {
    return BankPlayer(bank, seed);
  } catch (const std::invalid_argument& error) {
    throw InputError(bank.name, error.what());
  }
}

}  // namespace

Resynthesis resynthesise(const ClickBank& bank, double seconds, std::uint64_t seed,
                         const DrillControls& controls, const Progress& progress) {
  BankPlayer player = player_of(bank, seed);
  const auto frames = static_cast<std::size_t>(std::llround(seconds * bank.sample_rate));
  Resynthesis result;
  result.sound.reserve(frames + kChunk);
  double chunk[kChunk];
  while (result.sound.size() < frames) {
    const auto start = static_cast<double>(result.sound.size());
    if (progress) progress(start / static_cast<double>(frames));
    player.process(controls, chunk);
    for (const Impact& impact : player.impacts())
      result.impacts.push_back({start + impact.onset, impact.amplitude});
    for (const double v : chunk) result.sound.push_back(static_cast<float>(v));
  }
  result.sound.resize(frames);
  while (!result.impacts.empty() && result.impacts.back().time >= static_cast<double>(frames))
    result.impacts.pop_back();
  return result;
}

}  // namespace rigsound::analysis
