#include "sound_set/bank_json.hpp"

#include <nlohmann/json.hpp>

#include "json/json_file.hpp"

namespace rigsound::config {
namespace {

struct Field {
  const char* key;
  double ClickBank::*member;
  double min, max;
};

// One line a number of bank.json, in the order they are written. Times are samples, so a 192 kHz bank of
// one strike a second still fits.
constexpr Field kFields[] = {
    {"sample_rate", &ClickBank::sample_rate, 8000, 192000},
    {"T0", &ClickBank::mean_gap_samples, 16, 1e7},
    {"sigma_T", &ClickBank::gap_deviation_samples, 0, 1e7},
    {"r_T", &ClickBank::gap_correlation, -0.9, 0.9},
    {"p_miss", &ClickBank::miss_share, 0, 1},
    {"p_double", &ClickBank::double_share, 0, 1},
    {"B", &ClickBank::mean_amplitude, 1e-12, 1e6},
    {"sigma_B", &ClickBank::amplitude_deviation, 0, 1e6},
    {"r_B", &ClickBank::amplitude_correlation, -0.9, 0.9},
    {"N_a", &ClickBank::attack_samples, 0, 1e6},
    {"alpha_a", &ClickBank::attack_bend, -10, 10},
    {"alpha_d", &ClickBank::decay, 0, 1},
    {"gain_db", &ClickBank::gain_db, -60, 24},
};

/// What depends on another number of the file, as the engine demands it.
void require_consistent(const JsonFile& json, const ClickBank& bank) {
  json.number("T0", bank.sample_rate / 200, bank.sample_rate);
  json.number("sigma_T", 0, 2 * bank.mean_gap_samples);
  json.number("sigma_B", 0, 4 * bank.mean_amplitude);
  json.number("p_double", 0, 1 - bank.miss_share);
  json.number("N_a", 0, bank.sample_rate);
}

}  // namespace

std::string bank_json(const ClickBank& bank, const Provenance& provenance) {
  nlohmann::ordered_json json;
  json["format"] = kBankFormat;
  for (const Field& field : kFields) json[field.key] = bank.*field.member;
  json["source_file"] = provenance.source_file;
  json["source_sha256"] = provenance.source_sha256;
  json["settings"] = provenance.settings;
  json["tool_version"] = provenance.tool_version;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

StoredBank read_bank_json(const std::filesystem::path& file) {
  const JsonFile json(file);
  json.require_format(kBankFormat);
  StoredBank stored;
  for (const Field& field : kFields) stored.bank.*field.member = json.number(field.key, field.min, field.max);
  stored.bank.sample_rate = json.integer("sample_rate", 8000, 192000);  // a WAV file has no other rates
  require_consistent(json, stored.bank);
  stored.provenance = {json.text("source_file"), json.text("source_sha256"), json.text("settings"),
                       json.text("tool_version")};
  return stored;
}

}  // namespace rigsound::config
