// A bank whose clicks lie beside those of others.
#pragma once

#include "rigsound/config/bank_files.hpp"
#include "sound_set/click_store.hpp"

namespace rigsound::config {

/// As load_bank() of bank_files.hpp, clicks in `store`. Errors: InputError. Thread: OFF.
StoredBank load_bank(const std::filesystem::path& bank_folder, ClickStore& store);

}  // namespace rigsound::config
