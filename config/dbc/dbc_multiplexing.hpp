// Which value of which multiplexor a signal needs, along the whole chain.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rigsound/config/dbc.hpp"

namespace rigsound::config {

/// How one signal takes part in the multiplexing of its message.
struct DbcMux {
  bool is_multiplexor = false;  ///< M or mNM
  bool is_multiplexed = false;  ///< mN or mNM
  std::uint64_t value = 0;      ///< N
  std::string parent;           ///< SG_MUL_VAL_; empty: the one plain M of the message
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;  ///< SG_MUL_VAL_; empty: just N
};

/// Reads "M", "m12", "m12M"; false for any other word.
bool parse_mux(std::string_view word, DbcMux& mux);

/// Fills the selectors of every signal of the message. `mux`: by signal name.
/// Errors: InputError for a multiplexor that is not there, or that hangs on itself.
void resolve_multiplexing(DbcMessage& message, const std::map<std::string, DbcMux>& mux,
                          const std::string& file);

}  // namespace rigsound::config
