#include "sound_set/bank_json.hpp"

#include "json/json_reader.hpp"
#include "json/json_writer.hpp"
#include "rigsound/config/json.hpp"

namespace rigsound::config {

std::string bank_json(const ClickBank& bank, const Provenance& provenance) {
  Json json;
  json["format"] = kBankFormat;
  JsonWriter writer(json);
  writer.write(bank);
  writer.write(provenance);
  return json_text(json);
}

StoredBank read_bank_json(const JsonFile& json) {
  json.require_format(kBankFormat);
  StoredBank stored;
  JsonReader reader(json, JsonKeys::kAll);
  reader.read(stored.bank);
  reader.read(stored.provenance);
  return stored;
}

}  // namespace rigsound::config
