#include "json/json_file.hpp"

#include <nlohmann/json.hpp>

#include "json/json_positions.hpp"
#include "rigsound/config/json_depth.hpp"
#include "rigsound/machine/input_error.hpp"
#include "text/read_text.hpp"

namespace rigsound::config {
namespace {

constexpr std::size_t kMostObjects = 1024, kMostNumbers = 1 << 20;  // in a list

std::string kind(const nlohmann::json& value) {
  switch (value.type()) {
    case nlohmann::json::value_t::object:
      return "an object";
    case nlohmann::json::value_t::array:
      return "a list";
    case nlohmann::json::value_t::string:
      return "text";
    case nlohmann::json::value_t::boolean:
      return "true or false";
    case nlohmann::json::value_t::null:
      return "null";
    default:
      return "a number";
  }
}

}  // namespace

struct JsonFile::Document {
  explicit Document(const std::filesystem::path& path)
      : file(path.string()), text(read_text(path, kModelText)) {
    if (const std::size_t deep = position_below(text, kMaxJsonDepth); deep != kNowhere)
      refuse(line_at(text, deep), "has brackets more than " + std::to_string(kMaxJsonDepth) +
                                      " levels deep, expected a file that rigsound writes");
    try {
      root = nlohmann::json::parse(text);
    } catch (const nlohmann::json::out_of_range&) {
      refuse(0, "holds a number too large to represent");
    } catch (const nlohmann::json::parse_error& error) {
      refuse(line_at(text, error.byte), "is not valid JSON here");
    }
    if (!root.is_object()) refuse(1, "is no JSON object, expected { \"format\": ... }");
  }

  [[noreturn]] void refuse(int line, std::string_view problem) const {
    throw InputError(file, line, {}, problem);
  }

  std::string file, text;
  nlohmann::json root;
};

JsonFile::JsonFile(const std::filesystem::path& file)
    : document_(std::make_shared<Document>(file)), node_(&document_->root), position_(0) {}

JsonFile::JsonFile(const JsonFile& outer, const nlohmann::json& item, const std::string& path,
                   std::size_t position)
    : document_(outer.document_), node_(&item), path_(outer.path_ + path + "."), position_(position) {}

bool JsonFile::has(std::string_view key) const { return node_->contains(key); }

std::vector<std::string> JsonFile::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : node_->items()) keys.push_back(key);
  return keys;
}

const nlohmann::json& JsonFile::value(std::string_view key) const {
  const auto it = node_->find(key);
  if (it == node_->end()) fail(key, "is missing");
  return *it;
}

JsonFile JsonFile::object(std::string_view key) const {
  const nlohmann::json& item = value(key);
  if (!item.is_object()) fail_kind(key, item, "an object { }");
  return {*this, item, std::string(key), document_->text.find('{', position_of(key))};
}

std::vector<JsonFile> JsonFile::objects(std::string_view key) const {
  const nlohmann::json& list = value(key);
  if (!list.is_array()) fail_kind(key, list, "a list of objects");
  require_at_most(kMostObjects, key, list, "objects");
  for (const nlohmann::json& item : list)
    if (!item.is_object()) fail(key, "holds " + kind(item) + ", expected objects { }");
  const std::vector<std::size_t> positions = item_positions(document_->text, position_of(key));
  std::vector<JsonFile> found;
  for (std::size_t i = 0; i < list.size(); ++i)
    found.push_back({*this, list[i], std::string(key) + "[" + std::to_string(i) + "]",
                     i < positions.size() ? positions[i] : position_});  // a key may stand there twice
  return found;
}

double JsonFile::checked(std::string_view key, const nlohmann::json& value, const Range& range) const {
  const double x = value.get<double>();
  if (!range.holds(x)) fail(key, range.problem(x));
  return x;
}

double JsonFile::number(std::string_view key, const Range& range) const {
  const nlohmann::json& v = value(key);
  if (!v.is_number()) fail_kind(key, v, "a number, " + range.text());
  return checked(key, v, range);
}

bool JsonFile::flag(std::string_view key) const {
  const nlohmann::json& v = value(key);
  if (!v.is_boolean()) fail_kind(key, v, "true or false");
  return v.get<bool>();
}

std::string JsonFile::text(std::string_view key) const {
  const nlohmann::json& v = value(key);
  if (!v.is_string()) fail_kind(key, v, "text in quotes");
  return v.get<std::string>();
}

std::vector<float> JsonFile::floats(std::string_view key, const Range& range) const {
  const nlohmann::json& v = value(key);
  if (!v.is_array()) fail_kind(key, v, "a list of numbers, " + range.text());
  require_at_most(kMostNumbers, key, v, "numbers");
  std::vector<float> list;
  for (const nlohmann::json& item : v) {
    if (!item.is_number()) fail(key, "holds " + kind(item) + ", expected numbers, " + range.text());
    list.push_back(static_cast<float>(checked(key, item, range)));
  }
  return list;
}

std::vector<std::array<double, 2>> JsonFile::pairs(std::string_view key, const Range& range,
                                                   std::size_t most) const {
  const nlohmann::json& v = value(key);
  const std::string pairs = "pairs [b, c] of numbers, " + range.text();
  const std::string expected = "at most " + std::to_string(most) + " " + pairs;
  if (!v.is_array()) fail_kind(key, v, expected);
  require_at_most(most, key, v, pairs);
  std::vector<std::array<double, 2>> list;
  for (const nlohmann::json& pair : v) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number())
      fail(key, "holds something else, expected " + expected);
    list.push_back({checked(key, pair[0], range), checked(key, pair[1], range)});
  }
  return list;
}

void JsonFile::require_format(int format) const {
  const int found = static_cast<int>(number("format", kFormatNumbers.whole()));
  if (found != format)
    fail("format", "version " + std::to_string(found) + " is not known, expected " + std::to_string(format));
}

void JsonFile::fail_kind(std::string_view key, const nlohmann::json& found, std::string_view expected) const {
  fail(key, "is " + kind(found) + ", expected " + std::string(expected));
}

void JsonFile::require_at_most(std::size_t most, std::string_view key, const nlohmann::json& list,
                               std::string_view what) const {
  if (list.size() > most)
    fail(key, "is a list of " + std::to_string(list.size()) + ", expected at most " + std::to_string(most) +
                  " " + std::string(what));
}

void JsonFile::fail(std::string_view key, std::string_view problem) const {
  throw InputError(document_->file, line_at(document_->text, position_of(key)), path_ + std::string(key),
                   problem);
}

void JsonFile::fail(const InvalidField& error) const {
  JsonFile inner = *this;
  std::string_view path = error.key();
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
    const std::string_view step = path.substr(0, dot);
    const std::size_t bracket = step.find('[');
    const std::string_view key = step.substr(0, bracket);
    if (!inner.has(key)) break;
    inner = bracket == std::string_view::npos
                ? inner.object(key)
                : inner.objects(key).at(std::stoul(std::string(step.substr(bracket + 1))));
    path.remove_prefix(dot + 1);
  }
  inner.fail(path, error.problem());
}

/// Of the object itself when it has no such key.
std::size_t JsonFile::position_of(std::string_view key) const {
  const std::size_t position = key_position(document_->text, position_, key);
  return position == kNowhere ? position_ : position;
}

}  // namespace rigsound::config
