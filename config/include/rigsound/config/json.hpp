// JSON of the programs: one type, and what reads and writes its text, which takes a compiler seconds wherever
// it is compiled.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace rigsound {

/// Keys stay in the order in which they were set.
using Json = nlohmann::ordered_json;

namespace config {

/// What `text` says; is_discarded() where it is no JSON. Thread: any.
Json parsed_json(std::string_view text);

/// On one line, or objects and lists over several, two spaces a level; without a newline at the end. Bytes
/// that are no UTF-8 are replaced: a name must not cost the figures. Thread: any.
std::string json_line(const Json& json);
std::string json_lines(const Json& json);

}  // namespace config
}  // namespace rigsound
