// soundset.toml as text: what a new file begins with and what an entry looks like.
#pragma once

#include <string>
#include <string_view>

#include "rigsound/config/sound_set_index.hpp"

namespace rigsound::config {

/// The comments and the format line of a new soundset.toml.
std::string index_preamble();

/// One [[bank]], [[rock]], [[tool]] or [[background]], a blank line before it.
std::string index_bank_text(const BankEntry& entry);
std::string index_laws_text(const LawsEntry& laws);
std::string index_name_text(std::string_view kind, std::string_view name);

}  // namespace rigsound::config
