#include "rigsound/config/background_files.hpp"

#include <cmath>
#include <string>

#include "rigsound/config/names.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/atomic_folder.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/background_json.hpp"
#include "sound_set/mono_wav.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

fs::path grains_file(std::size_t point) { return "grains_" + std::to_string(point + 1) + ".wav"; }

std::size_t grain_samples(const DieselModel& model) {
  return static_cast<std::size_t>(model.angle_samples * (1 + kGrainOverlap));
}

void save_sounds(const fs::path& folder, const DieselModel& model) {
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const DieselPoint& point = model.points[i];
    if (point.grains.empty()) continue;
    std::vector<float> row;
    for (const auto& grain : point.grains) row.insert(row.end(), grain.begin(), grain.end());
    // The rate at which an editor plays the cycles at their own speed.
    write_mono_wav(folder / grains_file(i), row,
                   static_cast<int>(std::lround(model.angle_samples * point.rpm / 120)));
  }
  const int rate = static_cast<int>(std::lround(model.sample_rate));
  if (!model.start.empty()) write_mono_wav(folder / "start.wav", model.start, rate);
  if (!model.stop.empty()) write_mono_wav(folder / "stop.wav", model.stop, rate);
}

std::vector<std::vector<float>> load_grains(const fs::path& file, std::size_t samples) {
  std::vector<std::vector<float>> grains;
  if (!fs::exists(file)) return grains;
  const std::vector<float> row = read_mono_wav(file).samples;
  if (row.size() % samples != 0)
    throw InputError(file.string(), std::to_string(row.size()) + " samples, expected a multiple of " +
                                        std::to_string(samples) + " (1.25 N_theta)");
  for (auto at = row.begin(); at != row.end(); at += static_cast<std::ptrdiff_t>(samples))
    grains.emplace_back(at, at + static_cast<std::ptrdiff_t>(samples));
  return grains;
}

std::vector<float> load_shot(const fs::path& file, double sample_rate) {
  if (!fs::exists(file)) return {};
  MonoWav wav = read_mono_wav(file);
  if (wav.sample_rate != static_cast<int>(std::lround(sample_rate)))
    throw InputError(file.string(), std::to_string(wav.sample_rate) +
                                        " Hz, expected the sample_rate of background.json, " +
                                        std::to_string(std::lround(sample_rate)) + " Hz");
  return std::move(wav.samples);
}

}  // namespace

void save_background(const fs::path& sound_set, const DieselModel& background) {
  const fs::path folder = sound_set / "backgrounds" / background.name;
  if (!is_name(background.name))
    throw InputError(sound_set.string(), 0, background.name,
                     "is no background name, " + std::string(kNameRule));
  AtomicFolder files(folder);
  write_file(files.temporary() / "background.json", background_json(background));
  save_sounds(files.temporary(), background);
  load_background(files.temporary());  // what the loader would refuse is refused before it is in place
  files.commit();
}

DieselModel load_background(const fs::path& folder) {
  const JsonFile json(folder / "background.json");
  DieselModel model = read_background_json(json);
  model.name = folder.filename().string();
  for (std::size_t i = 0; i < model.points.size(); ++i)
    model.points[i].grains = load_grains(folder / grains_file(i), grain_samples(model));
  model.start = load_shot(folder / "start.wav", model.sample_rate);
  model.stop = load_shot(folder / "stop.wav", model.sample_rate);
  try {
    require_valid(model);
  } catch (const InvalidField& error) {
    json.fail(error);
  }
  return model;
}

}  // namespace rigsound::config
