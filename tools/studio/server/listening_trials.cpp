#include "listening_trials.hpp"

#include <algorithm>
#include <random>

#include "access.hpp"

namespace rigsound::studio {
namespace {

constexpr std::size_t kMostTrials = 64, kMostWithSounds = 8;

template <class Trials>
auto& trial_of(Trials& trials, const std::string& id) {
  const auto trial =
      std::find_if(trials.begin(), trials.end(), [&](const auto& one) { return one.id == id; });
  if (trial == trials.end()) throw ApiError(404, "there is no such trial");
  return *trial;
}

}  // namespace

std::string ListeningTrials::open(ListeningTrial trial) {
  trial.id = new_token();
  const std::lock_guard lock(mutex_);
  trials_.push_front(std::move(trial));
  if (trials_.size() > kMostTrials) trials_.pop_back();
  if (trials_.size() > kMostWithSounds)
    std::next(trials_.begin(), static_cast<long>(kMostWithSounds))->waves.clear();
  return trials_.front().id;
}

std::string ListeningTrials::wave(const std::string& id, const std::string& place) const {
  const std::lock_guard lock(mutex_);
  const ListeningTrial& trial = trial_of(trials_, id);
  const auto sound = std::find_if(trial.sounds.begin(), trial.sounds.end(),
                                  [&](const auto& one) { return one.first == place; });
  if (sound == trial.sounds.end()) throw ApiError(404, "the trial has no such sound");
  const auto wave = trial.waves.find(sound->second);
  if (wave == trial.waves.end()) throw ApiError(404, "the trial has ended");
  return wave->second;
}

ListeningTrial ListeningTrials::end(const std::string& id) {
  const std::lock_guard lock(mutex_);
  ListeningTrial& trial = trial_of(trials_, id);
  trial.waves.clear();
  return trial;
}

std::vector<std::pair<std::string, std::string>> abx_places(std::vector<std::string> kinds) {
  std::random_device chance;
  std::shuffle(kinds.begin(), kinds.end(), chance);
  const std::size_t x = std::uniform_int_distribution<std::size_t>(0, 1)(chance);
  return {{"a", kinds[0]}, {"b", kinds[1]}, {"x", kinds[x]}};
}

std::vector<std::pair<std::string, std::string>> rating_places(std::vector<std::string> kinds) {
  std::vector<std::pair<std::string, std::string>> places = {{"reference", kinds[0]}};
  std::random_device chance;
  std::shuffle(kinds.begin(), kinds.end(), chance);
  for (std::size_t i = 0; i < kinds.size(); ++i) places.emplace_back(std::to_string(i + 1), kinds[i]);
  return places;
}

}  // namespace rigsound::studio
