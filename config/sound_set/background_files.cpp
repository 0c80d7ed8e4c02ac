#include "rigsound/config/background_files.hpp"

#include <nlohmann/json.hpp>

#include "json/json_file.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/atomic_folder.hpp"
#include "rigsound/input_error.hpp"
#include "sound_set/names.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

namespace {

constexpr int kBackgroundFormat = 1;

}  // namespace

void save_background(const fs::path& sound_set, const BackgroundModel& background) {
  const fs::path folder = sound_set / "backgrounds" / background.name;
  if (!is_name(background.name))
    throw InputError(sound_set.string(), 0, background.name,
                     "is no background name, " + std::string(kNameRule));
  nlohmann::ordered_json json;
  json["format"] = kBackgroundFormat;
  json["rpm"] = background.rpm;
  json["order_amplitude"] = background.order_amplitude;
  json["noise_level"] = background.noise_level;
  AtomicFolder files(folder);
  write_file(files.temporary() / "background.json", json.dump(2) + "\n");
  load_background(files.temporary());  // what the loader would refuse is refused before it is in place
  files.commit();
}

BackgroundModel load_background(const fs::path& folder) {
  const JsonFile json(folder / "background.json");
  json.require_format(kBackgroundFormat);
  BackgroundModel background;
  background.name = folder.filename().string();
  background.rpm = json.number("rpm", 100, 8000);
  background.order_amplitude = json.floats("order_amplitude", 0, 10);
  background.noise_level = static_cast<float>(json.number("noise_level", 0, 10));
  if (background.order_amplitude.empty())
    json.fail("order_amplitude", "is empty, expected at least one order");
  return background;
}

}  // namespace rigsound::config
