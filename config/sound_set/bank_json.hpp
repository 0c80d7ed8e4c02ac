// bank.json: the numbers of one bank and where they came from.
#pragma once

#include <filesystem>
#include <string>

#include "rigsound/config/bank_files.hpp"

namespace rigsound::config {

/// The text of bank.json. Numbers round-trip exactly.
std::string bank_json(const ClickBank& bank, const Provenance& provenance);

/// Everything but the clicks, every value checked. Errors: InputError.
StoredBank read_bank_json(const std::filesystem::path& file);

}  // namespace rigsound::config
