// BA_DEF_, BA_DEF_DEF_, BA_: the attributes of a DBC that change what we do.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dbc/dbc_cursor.hpp"
#include "rigsound/config/dbc.hpp"

namespace rigsound::config {

/// True for the word before a message, a signal, a node or an environment variable.
bool is_dbc_object(std::string_view word);

class DbcAttributes {
 public:
  void read_definition(DbcCursor& at);  ///< BA_DEF_
  void read_default(DbcCursor& at);     ///< BA_DEF_DEF_
  void read_value(DbcCursor& at);       ///< BA_

  /// Sets cycle time, J1939 matching and long names of a message whose identifier the file writes as
  /// `raw_id`.
  void apply(std::int64_t raw_id, DbcMessage& message) const;

 private:
  /// The value for this message, else the default, else nothing. Values of enumerations as their words.
  std::optional<std::string> of_message(const std::string& attribute, std::int64_t raw_id) const;

  std::map<std::string, std::vector<std::string>> words_;  ///< of enumerations
  std::map<std::string, std::string> defaults_;
  std::map<std::pair<std::string, std::int64_t>, std::string> message_values_;
  std::map<std::pair<std::string, std::int64_t>, std::string> long_signals_;  ///< by name and raw identifier
};

}  // namespace rigsound::config
