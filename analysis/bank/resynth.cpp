#include "rigsound/analysis/resynth.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rigsound/bank_player.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kUnheardRate_hz = 160;  // mean rate of impacts whose sound does not count

BankPlayer player_of(const ClickBank& bank, std::uint64_t seed) {
  try {
    return BankPlayer(bank, seed);
  } catch (const std::invalid_argument& error) {
    throw InputError(bank.name, error.what());
  }
}

/// Every click one sample, as high as its number: what is heard tells which one is played. Gaps `faster` than
/// those of the bank, in which the engine counts time: silence takes it as long as sound.
ClickBank numbered(const ClickBank& bank, double faster) {
  ClickBank numbers = bank;
  for (std::size_t c = 0; c < numbers.clicks.size(); ++c)
    numbers.clicks[c] = {static_cast<float>(c + 1) / static_cast<float>(numbers.clicks.size())};
  numbers.gain_db = 0, numbers.mean_amplitude = 1;
  numbers.amplitude_deviation /= bank.mean_amplitude;
  numbers.mean_gap_samples /= faster, numbers.gap_deviation_samples /= faster;
  return numbers;
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

std::vector<PlayedClick> played_clicks(const ClickBank& bank, std::size_t count, std::uint64_t seed) {
  const double faster = std::max(1.0, bank.mean_gap_samples * kUnheardRate_hz / bank.sample_rate);
  BankPlayer player = player_of(numbered(bank, faster), seed);
  std::vector<PlayedClick> played;
  double chunk[kChunk];
  std::size_t heard = 0;
  for (double start = 0; heard < count; start += kChunk) {
    player.process({}, chunk);
    for (const Impact& impact : player.impacts())
      played.push_back({(start + impact.onset) * faster, impact.amplitude, 0});
    for (const double sample : chunk) {
      if (sample == 0) continue;
      PlayedClick& here = played[heard++];
      const double number = sample / here.amplitude * static_cast<double>(bank.clicks.size());
      here.click = static_cast<std::size_t>(std::lround(number)) - 1;
    }
  }
  played.resize(count);
  return played;
}

}  // namespace rigsound::analysis
