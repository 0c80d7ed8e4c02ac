#include "rigsound/config/refinement.hpp"

#include <algorithm>

#include "json/json_file.hpp"
#include "json/json_writer.hpp"
#include "rigsound/config/json.hpp"
#include "rigsound/refined_bank.hpp"
#include "sound_set/clicks_wav.hpp"

namespace rigsound::config {
namespace fs = std::filesystem;

std::optional<Refinement> load_refinement(const fs::path& bank_folder) {
  std::error_code none;
  const fs::path file = bank_folder / kRefinementFile;
  if (!fs::exists(file, none)) return std::nullopt;
  const JsonFile json(file);
  json.require_format(kRefinementFormat);
  Refinement refinement;
  const JsonFile controls = json.object("controls");
  for (const ControlInfo& control : control_table()) {
    const double value = controls.number(control.name, control.range());
    refinement.controls.*control.field = static_cast<float>(value);
  }
  for (const float click : json.floats("dropped", Range{0, kMaxBankClicks - 1}))
    refinement.dropped.push_back(static_cast<int>(click));
  refinement.trim_db = json.number("trim_db", kRefinementTrims);
  return refinement;
}

ClickBank refined(const ClickBank& analysed, const Refinement& refinement) {
  ClickBank bank = analysed;
  const int clicks = static_cast<int>(bank.clicks.size());
  std::vector<bool> dropped(bank.clicks.size(), false);
  for (const int click : refinement.dropped) {
    if (click < 0 || click >= clicks)
      throw InvalidField(
          "", "dropped",
          "there is no click " + std::to_string(click) + ", expected 0 to " + std::to_string(clicks - 1));
    dropped[static_cast<std::size_t>(click)] = true;
  }
  bank.clicks.clear();
  for (std::size_t c = 0; c < dropped.size(); ++c)
    if (!dropped[c]) bank.clicks.push_back(analysed.clicks[c]);
  if (static_cast<int>(bank.clicks.size()) < std::min(kLeastRefinedClicks, clicks))
    throw InvalidField("", "dropped",
                       "leaves " + std::to_string(bank.clicks.size()) + " clicks, expected " +
                           std::to_string(kLeastRefinedClicks) + " or more");
  bank.gain_db += refinement.trim_db;
  return refined_bank(bank, refinement.controls);
}

std::string refinement_text(const Refinement& refinement) {
  Json json{{"format", kRefinementFormat}};
  for (const ControlInfo& control : control_table())
    json["controls"][std::string(control.name)] = refinement.controls.*control.field;
  json["dropped"] = refinement.dropped;
  json["trim_db"] = refinement.trim_db;
  return json_text(json);
}

}  // namespace rigsound::config
