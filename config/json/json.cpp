#include "rigsound/config/json.hpp"

namespace rigsound::config {
namespace {

std::string dumped(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json parsed_json(std::string_view text) { return Json::parse(text, nullptr, false); }

std::string json_line(const Json& json) { return dumped(json, -1); }
std::string json_lines(const Json& json) { return dumped(json, 2); }

}  // namespace rigsound::config
