#include "toml/toml_table.hpp"

#include <algorithm>

#include "rigsound/config/nearest_word.hpp"
#include "rigsound/machine/input_error.hpp"
#include "text/read_text.hpp"

namespace rigsound::config {
namespace {

std::string kind(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

}  // namespace

TomlTable::TomlTable(std::shared_ptr<const std::string> file, std::shared_ptr<const toml::table> table,
                     std::string path)
    : file_(std::move(file)), table_(std::move(table)), path_(std::move(path)) {}

TomlTable TomlTable::parse(std::string_view text, const std::string& file) {
  try {
    auto table = std::make_shared<const toml::table>(toml::parse(text, file));
    return TomlTable(std::make_shared<const std::string>(file), std::move(table), {});
  } catch (const toml::parse_error& error) {
    throw InputError(file, static_cast<int>(error.source().begin.line), {}, std::string(error.description()));
  }
}

const toml::node* TomlTable::known(std::string_view key) {
  known_.emplace(key);
  return table_->get(key);
}

double TomlTable::number(std::string_view key, double otherwise, const Range& range) {
  const toml::node* node = known(key);
  if (node == nullptr) return otherwise;
  if (!node->is_number()) fail(key, "is " + kind(*node) + ", expected a number, " + range.text());
  const double x = *node->value<double>();
  if (!range.holds(x)) fail(key, range.problem(x));
  return x;
}

std::int64_t TomlTable::integer(std::string_view key, std::int64_t otherwise, const Range& range) {
  const auto given = number(key, static_cast<double>(otherwise), range.step == 0 ? range.whole() : range);
  return static_cast<std::int64_t>(given);
}

bool TomlTable::flag(std::string_view key, bool otherwise) {
  const toml::node* node = known(key);
  if (node == nullptr) return otherwise;
  if (!node->is_boolean()) fail(key, "is " + kind(*node) + ", expected true or false");
  return *node->value<bool>();
}

std::string TomlTable::text(std::string_view key, std::string_view otherwise) {
  const toml::node* node = known(key);
  if (node == nullptr) return std::string(otherwise);
  if (!node->is_string()) fail(key, "is " + kind(*node) + ", expected text in quotes");
  return *node->value<std::string>();
}

void TomlTable::require(std::string_view key, std::string_view expected) {
  if (known(key) != nullptr) return;
  for (const std::string& other : keys())
    if (known_.count(other) == 0 && edit_distance(other, key) <= 2)
      fail(other, "is not known here, did you mean '" + std::string(key) + "'?");
  fail(key, "is missing, expected " + std::string(expected));
}

std::string TomlTable::required_text(std::string_view key, std::string_view expected) {
  require(key, expected);
  std::string given = text(key, {});
  if (given.empty()) fail(key, "is empty, expected " + std::string(expected));
  return given;
}

std::vector<std::string> TomlTable::texts(std::string_view key) {
  const toml::node* node = known(key);
  if (node == nullptr) return {};
  const toml::array* list = node->as_array();
  if (list == nullptr) fail(key, "is " + kind(*node) + ", expected a list of texts [\"...\", \"...\"]");
  std::vector<std::string> words;
  for (const toml::node& item : *list) {
    if (!item.is_string()) fail(key, "holds " + kind(item) + ", expected a list of texts [\"...\", \"...\"]");
    words.push_back(*item.value<std::string>());
  }
  return words;
}

std::vector<std::string> TomlTable::one_or_more_texts(std::string_view key, std::string_view expected) {
  const toml::node* node = known(key);
  if (node == nullptr || !node->is_array()) return {required_text(key, expected)};
  std::vector<std::string> given = texts(key);
  if (given.empty()) fail(key, "is empty, expected " + std::string(expected));
  return given;
}

TomlTable TomlTable::table(std::string_view key) {
  const toml::node* node = known(key);
  if (node == nullptr) return TomlTable(file_, std::make_shared<const toml::table>(), path_of(key));
  if (!node->is_table()) fail(key, "is " + kind(*node) + ", expected a table [" + path_of(key) + "]");
  return TomlTable(file_, {table_, node->as_table()}, path_of(key));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  const toml::node* node = known(key);
  if (node == nullptr) return {};
  if (node->is_table()) return {table(key)};
  const toml::array* list = node->as_array();
  const std::string expected = "expected tables [[" + path_of(key) + "]]";
  if (list == nullptr) fail(key, "is " + kind(*node) + ", " + expected);
  std::vector<TomlTable> entries;
  for (const toml::node& item : *list) {
    if (!item.is_table()) fail(key, "holds " + kind(item) + ", " + expected);
    entries.push_back(TomlTable(file_, {table_, item.as_table()}, path_of(key)));
  }
  return entries;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::pair<toml::source_position, std::string>> found;
  for (const auto& [key, node] : *table_) found.emplace_back(key.source().begin, std::string(key.str()));
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [where, key] : found) names.push_back(std::move(key));
  return names;
}

bool TomlTable::is_table(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_table();
}

bool TomlTable::is_text(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node != nullptr && node->is_string();
}

void TomlTable::refuse_unknown() const {
  for (const std::string& key : keys()) {
    if (known_.count(key) != 0) continue;
    const std::string_view near = nearest_word(key, known_);
    fail(key, "is not known here, " + (near.empty() ? "expected none of that name"
                                                    : "did you mean '" + std::string(near) + "'?"));
  }
}

void TomlTable::fail(std::string_view key, std::string_view message) const {
  throw InputError(*file_, line_of(key), path_of(key), message);
}

void TomlTable::fail(const InvalidField& error) const {
  std::string_view place = error.key();  // where the key is not in the file, the table that it belongs to is
  toml::node_view<const toml::node> node;
  while (!place.empty() && !(node = toml::at_path(*table_, place)))
    place =
        place.substr(0, place.find_last_of(".[") == std::string_view::npos ? 0 : place.find_last_of(".["));
  const toml::source_region& where = node ? node.node()->source() : table_->source();
  throw InputError(*file_, static_cast<int>(where.begin.line), path_of(error.key()), error.problem());
}

std::string TomlTable::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

int TomlTable::line_of(std::string_view key) const {
  for (const auto& [k, node] : *table_)
    if (k.str() == key) return static_cast<int>(k.source().begin.line);
  return static_cast<int>(table_->source().begin.line);
}

}  // namespace rigsound::config
