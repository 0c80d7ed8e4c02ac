// The daemon's answers in words, as status and watch both show them.
#pragma once

#include <string>
#include <string_view>

#include "ctl/control_client.hpp"

namespace rigsound::tools {

std::string bar_of(double db, int width);      ///< `####....`, -60...0 dBFS
std::string db_text(double db);                ///< "-12.3", or "silent"
std::string duration_text(double seconds);     ///< "1:02:03"
std::string value_text(const Json& signal);    ///< its word, or its number
std::string_view mark_of(const Json& signal);  ///< of its validity: "manual", "stale", ...; empty: valid
bool is_told(const Json& signal);              ///< a bus or a user has said it
std::string asked_and_got(
    const Json& boom);  ///< "6>3 / granite": rods and rock asked for, what the bank has where it differs
std::string refused_text(const Json& signal);  ///< "12 refused, last 410, 3 clamped"; empty: none
/// "decay_factor 2, ..."; empty: all are neutral
std::string controls_text(const Json& boom);

}  // namespace rigsound::tools
