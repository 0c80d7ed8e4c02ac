// Reads the fields of a struct from a table of a TOML file; an archive of rigsound/machine/fields.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "toml/toml_table.hpp"

namespace rigsound::config {

/// People write times in ms: a field `fade_s` is the key `fade_ms` of a file.
inline std::string toml_key(const char* key, const Range& range) {
  if (std::string_view(range.unit) != "s") return key;
  const std::string_view name(key);
  return std::string(name.substr(0, name.size() - 1)) + "ms";  // _s
}

/// The same range as a file has it.
constexpr Range toml_range(const Range& range) {
  if (std::string_view(range.unit) != "s") return range;
  return {range.min * 1000, range.max * 1000, "ms", range.step * 1000, range.zero, range.decimals};
}

class TomlReader {
 public:
  explicit TomlReader(TomlTable& table) : table_(table) {}

  void operator()(const char* key, double& x, const Range& range) {
    const std::string name = toml_key(key, range);
    if (!table_.has(name)) return table_.expect(name);
    const bool time = name != key;
    x = table_.number(name, x, toml_range(range)) / (time ? 1000 : 1);
  }
  template <class Integer>
  void operator()(const char* key, Integer& x, const Range& range) {
    x = static_cast<Integer>(table_.integer(key, static_cast<std::int64_t>(x), range));
  }
  void operator()(const char* key, bool& on) { on = table_.flag(key, on); }
  void operator()(const char* key, std::string& text) { text = table_.text(key, text); }
  void operator()(const char* key, std::string& text, Label) { text = table_.text(key, text); }
  template <class E, std::size_t N>
  void operator()(const char* key, E& value, const Word<E> (&words)[N]) {
    value = table_.word(key, value, words);
  }
  template <class Struct>
  void operator()(const char* key, Struct& group) {
    TomlTable inner = table_.table(key);
    TomlReader reader(inner);
    fields(reader, group);
    inner.refuse_unknown();
  }
  template <class Item>
  void operator()(const char* key, std::vector<Item>& list) {
    for (TomlTable& item : table_.tables(key)) {
      TomlReader reader(item);
      fields(reader, list.emplace_back());
      item.refuse_unknown();
    }
  }

 private:
  TomlTable& table_;
};

/// The keys that are there; the others keep what they are.
template <class Options>
void read(TomlTable& table, Options& options) {
  TomlReader reader(table);
  fields(reader, options);
}

/// A table that holds these options and nothing else.
template <class Options>
Options read_all(TomlTable table) {
  Options options;
  read(table, options);
  table.refuse_unknown();
  return options;
}

}  // namespace rigsound::config
