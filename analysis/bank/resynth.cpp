#include "rigsound/analysis/resynth.hpp"

#include <algorithm>
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
  result.sound.resize(frames);
  double chunk[kChunk];
  for (std::size_t done = 0; done < frames; done += kChunk) {
    const auto start = static_cast<double>(done);
    if (progress) progress(start / static_cast<double>(frames));
    player.process(controls, chunk);
    for (const Impact& impact : player.impacts())
      result.impacts.push_back({start + impact.onset, impact.amplitude});
    std::copy_n(chunk, std::min<std::size_t>(kChunk, frames - done),
                result.sound.begin() + static_cast<long>(done));
  }
  while (!result.impacts.empty() && result.impacts.back().time >= static_cast<double>(frames))
    result.impacts.pop_back();
  return result;
}

}  // namespace rigsound::analysis
