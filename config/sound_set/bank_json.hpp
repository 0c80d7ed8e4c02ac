// bank.json: the numbers of one bank and where they came from.
#pragma once

#include <string>

#include "json/json_file.hpp"
#include "rigsound/config/bank_files.hpp"

namespace rigsound::config {

/// The text of bank.json. Numbers round-trip exactly.
std::string bank_json(const ClickBank& bank, const Provenance& provenance);

/// Everything but the clicks, each value in its range. Errors: InputError.
StoredBank read_bank_json(const JsonFile& json);

}  // namespace rigsound::config
