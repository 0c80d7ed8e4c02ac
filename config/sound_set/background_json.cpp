#include "sound_set/background_json.hpp"

#include "json/json_reader.hpp"
#include "json/json_writer.hpp"
#include "rigsound/config/json.hpp"

namespace rigsound::config {

std::string background_json(const DieselModel& model) {
  Json json;
  json["format"] = kBackgroundFormat;
  JsonWriter(json).write(model);
  return json_text(json);
}

DieselModel read_background_json(const JsonFile& json) {
  json.require_format(kBackgroundFormat);
  DieselModel model;
  JsonReader(json, JsonKeys::kAll).read(model);
  return model;
}

}  // namespace rigsound::config
