#include "http.hpp"

#include <charconv>
#include <cmath>

namespace rigsound::studio {
namespace {

constexpr int kMostLevels = 32;

/// The parser recurses for each bracket: a body of a megabyte of them must not reach the end of the stack.
bool too_deep(const std::string& text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMostLevels) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace

double Request::number(const std::string& name, double otherwise) const {
  const auto found = query.find(name);
  if (found == query.end()) return otherwise;
  const std::string& text = found->second;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw ApiError(400, name + ": is no number");
  return value;
}

Json Request::object() const {
  if (too_deep(body)) throw ApiError(400, "body: more than 32 levels of brackets");
  Json json = Json::parse(body, nullptr, false);
  if (!json.is_object()) throw ApiError(400, "body: expected a JSON object");
  return json;
}

Answer json_answer(const Json& json, int status) {
  Answer answer;
  answer.status = status;
  answer.body = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  return answer;
}

Answer error_answer(const ApiError& error) {
  Json json{{"error", error.what()}};
  json.update(error.more);
  return json_answer(json, error.status);
}

}  // namespace rigsound::studio
