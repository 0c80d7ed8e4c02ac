// The signal map of a CAN bus, as DBC files describe it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/can/signal_layout.hpp"

namespace rigsound::config {

struct DbcSignal {
  std::string name, unit, comment;             ///< UTF-8
  std::string long_name;                       ///< SystemSignalLongSymbol; empty: none given
  can::SignalLayout layout;                    ///< with the selectors of every multiplexor above it
  double min = 0, max = 0;                     ///< as written; 0, 0 means none
  std::map<std::int64_t, std::string> values;  ///< VAL_: raw value to text
  int line = 0;
};

struct DbcMessage {
  std::string name, comment;
  std::string long_name;  ///< SystemMessageLongSymbol; empty: none given
  std::string broken;  ///< `FILE:LINE: SECTION: ...` of a line of it that cannot be read; empty: it is whole
  std::uint32_t id = 0;  ///< 11 or 29 bits
  bool extended = false;
  bool j1939 = false;  ///< VFrameFormat is J1939PG
  int size = 0;        ///< bytes
  double cycle_s = 0;  ///< GenMsgCycleTime; 0: none given
  std::vector<std::string> senders;
  std::vector<DbcSignal> signals;
  int line = 0;

  const DbcSignal* find(std::string_view signal) const;  ///< by its name or its long name
};

struct Dbc {
  std::vector<std::string> nodes;
  std::vector<DbcMessage> messages;
  std::map<std::string, std::map<std::int64_t, std::string>> value_tables;
  std::vector<std::string> unread;  ///< `FILE:LINE: BO_: ...` of messages whose first line cannot be read

  const DbcMessage* find(std::string_view message) const;  ///< by its name or its long name
};

/// Reads BO_ SG_ BU_ VAL_ VAL_TABLE_ CM_ BA_DEF_ BA_DEF_DEF_ BA_ SIG_VALTYPE_ SG_MUL_VAL_ BO_TX_BU_ and
/// skips every other section. Text may be UTF-8 or Windows-1252. `file` is for messages. A line that cannot
/// be read costs the message it belongs to, and nothing else. Errors: InputError for UTF-16, and for line
/// ends of CR alone. Thread: OFF.
Dbc parse_dbc(std::string_view text, const std::string& file);
Dbc load_dbc(const std::filesystem::path& file);

}  // namespace rigsound::config
