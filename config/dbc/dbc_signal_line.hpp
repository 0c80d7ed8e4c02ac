// SG_: one signal of a message.
#pragma once

#include <map>
#include <string>

#include "dbc/dbc_cursor.hpp"
#include "dbc/dbc_multiplexing.hpp"
#include "rigsound/config/dbc.hpp"

namespace rigsound::config {

/// True for a word that begins a section.
bool is_dbc_section(std::string_view word);

/// Reads what follows SG_, and notes in `mux` how the signal is multiplexed. Errors: InputError.
DbcSignal read_signal_line(DbcCursor& at, std::map<std::string, DbcMux>& mux);

}  // namespace rigsound::config
