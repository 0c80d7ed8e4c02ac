#include "json/json_file.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/machine/input_error.hpp"
#include "text/number_text.hpp"
#include "text/read_text.hpp"

namespace rigsound::config {

JsonFile::JsonFile(const std::filesystem::path& file) : file_(file.string()), text_(read_text(file)) {
  try {
    root_ = nlohmann::json::parse(text_);
  } catch (const nlohmann::json::out_of_range&) {
    throw InputError(file_, 0, {}, "holds a number too large to represent");
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text_.size()));
    const int line = 1 + static_cast<int>(std::count(text_.begin(), end, '\n'));
    throw InputError(file_, line, {}, "is not valid JSON here");
  }
  if (!root_.is_object()) throw InputError(file_, 1, {}, "is no JSON object, expected { \"format\": ... }");
}

const nlohmann::json& JsonFile::value(std::string_view key) const {
  const auto it = root_.find(std::string(key));
  if (it == root_.end()) fail(key, "is missing");
  return *it;
}

JsonFile JsonFile::inside(std::string_view path, const nlohmann::json& item) const {
  if (!item.is_object()) fail(path, std::string("is ") + item.type_name() + ", expected an object { }");
  JsonFile copy = *this;
  copy.path_ = path_ + std::string(path) + ".";
  copy.root_ = item;
  return copy;
}

JsonFile JsonFile::object(std::string_view key) const { return inside(key, value(key)); }

std::vector<JsonFile> JsonFile::objects(std::string_view key) const {
  const nlohmann::json& list = value(key);
  if (!list.is_array()) fail(key, std::string("is ") + list.type_name() + ", expected a list of objects");
  std::vector<JsonFile> found;
  for (const nlohmann::json& item : list)
    found.push_back(inside(std::string(key) + "[" + std::to_string(found.size()) + "]", item));
  return found;
}

double JsonFile::number(std::string_view key, double min, double max) const {
  const nlohmann::json& v = value(key);
  const std::string expected = "expected a number " + range_text(min, max);
  if (!v.is_number()) fail(key, std::string("is ") + v.type_name() + ", " + expected);
  const double x = v.get<double>();
  if (!(x >= min && x <= max)) fail(key, number_text(x) + " is out of range, " + expected);
  return x;
}

int JsonFile::integer(std::string_view key, int min, int max) const {
  const double x = number(key, min, max);
  if (x != std::floor(x)) fail(key, number_text(x) + " is not whole, expected a whole number");
  return static_cast<int>(x);
}

std::string JsonFile::text(std::string_view key) const {
  const nlohmann::json& v = value(key);
  if (!v.is_string()) fail(key, std::string("is ") + v.type_name() + ", expected text in quotes");
  return v.get<std::string>();
}

std::vector<float> JsonFile::floats(std::string_view key, double min, double max) const {
  const nlohmann::json& v = value(key);
  const std::string expected = "expected a list of numbers " + range_text(min, max);
  if (!v.is_array()) fail(key, std::string("is ") + v.type_name() + ", " + expected);
  std::vector<float> list;
  for (const nlohmann::json& item : v) {
    const double x = item.is_number() ? item.get<double>() : NAN;
    if (!(x >= min && x <= max)) fail(key, item.dump() + " stands in the list, " + expected);
    list.push_back(static_cast<float>(x));
  }
  return list;
}

void JsonFile::require_format(int format) const {
  const int found = integer("format", 0, 1 << 20);
  if (found != format)
    fail("format", "version " + std::to_string(found) + " is not known, expected " + std::to_string(format));
}

void JsonFile::fail(std::string_view key, std::string_view message) const {
  throw InputError(file_, line_of(key), path_ + std::string(key), message);
}

int JsonFile::line_of(std::string_view key) const {
  const std::size_t at = text_.find('"' + std::string(key) + '"');
  if (at == std::string::npos) return 1;
  return 1 +
         static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace rigsound::config
