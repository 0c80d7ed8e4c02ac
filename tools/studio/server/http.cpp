#include "http.hpp"

#include <cmath>

#include "rigsound/config/json_depth.hpp"
#include "rigsound/number_of.hpp"

namespace rigsound::studio {

double Request::number(const std::string& name, double otherwise) const {
  const auto found = query.find(name);
  if (found == query.end()) return otherwise;
  const auto value = number_of<double>(found->second);
  if (!value || !std::isfinite(*value)) throw ApiError(400, name + ": is no number");
  return *value;
}

Json Request::object() const {
  if (config::position_below(body, config::kMaxJsonDepth) != std::string::npos)
    throw ApiError(400, "body: more than 32 levels of brackets");
  Json json = config::parsed_json(body);
  if (!json.is_object()) throw ApiError(400, "body: expected a JSON object");
  return json;
}

Answer json_answer(const Json& json, int status) {
  Answer answer;
  answer.status = status;
  answer.body = config::json_line(json) + "\n";
  return answer;
}

Answer bytes_answer(std::string bytes, const char* type) {
  Answer answer;
  answer.type = type;
  answer.body = std::move(bytes);
  return answer;
}

Answer wave_answer(std::string bytes) { return bytes_answer(std::move(bytes), "audio/wav"); }

Answer error_answer(const ApiError& error) {
  Json json{{"error", error.what()}};
  json.update(error.more);
  return json_answer(json, error.status);
}

}  // namespace rigsound::studio
