// The sound set as the page knows it.
#pragma once

#include <filesystem>
#include <string>

#include "workplace.hpp"

namespace rigsound::studio {

std::string sound_set_name(const Workplace& place);

/// SET/soundset.toml, there or not. Errors: ApiError 403 when it is a link out of the folder.
std::filesystem::path index_of(const Workplace& place);

/// SET/banks/NAME of a bank that is there. Errors: ApiError 404 and 403.
std::filesystem::path bank_folder(const Workplace& place, const std::string& name);

/// SET/backgrounds/NAME of a background that is there. Errors: ApiError 404 and 403.
std::filesystem::path background_folder(const Workplace& place, const std::string& name);

/// Changes with the analysis and with the refinement.
std::string bank_version(const std::filesystem::path& bank_folder);

Json sound_set_json(const Workplace& place);

}  // namespace rigsound::studio
