// A request and its answer, as the routes see them. Thread: each belongs to one.
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/config/json.hpp"

namespace rigsound::studio {

constexpr std::size_t kMostBodyBytes = 1 << 20, kMostResultBytes = 4 << 20;

/// Ends a request with a status and one line for people.
struct ApiError : std::runtime_error {
  ApiError(int its_status, const std::string& line) : std::runtime_error(line), status(its_status) {}
  ApiError(int its_status, const std::string& line, Json beside)
      : std::runtime_error(line), status(its_status), more(std::move(beside)) {}

  int status;
  Json more = Json::object();  ///< stands in the body beside `error`
};

struct Request {
  std::string method, path, body;
  std::map<std::string, std::string> query;  ///< the first of each name
  std::vector<std::string> words;            ///< what stood in the {} of the route, in order

  /// Errors: ApiError 400 when the number is no finite one.
  double number(const std::string& name, double otherwise) const;
  /// The body as a JSON object. Errors: ApiError 400.
  Json object() const;
};

struct Answer {
  int status = 200;
  std::string type = "application/json", body;
  std::map<std::string, std::string> headers;
  /// Of a stream: fills the next piece, empty while there is nothing to say; false: it has ended. An error
  /// that it throws ends the stream.
  std::function<bool(std::string& piece)> stream;
};

Answer json_answer(const Json& json, int status = 200);
Answer bytes_answer(std::string bytes, const char* type = "application/octet-stream");
Answer wave_answer(std::string bytes);  ///< of a WAV file
Answer error_answer(const ApiError& error);

}  // namespace rigsound::studio
