// One table of a TOML file, read key by key; what nobody asked for is refused.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rigsound/machine/fields.hpp"

namespace rigsound::config {

/// Every getter marks its key as known, gives `otherwise` when the key is absent and throws InputError
/// `FILE:LINE: KEY: what is wrong, what was expected` when the value is of another type or out of range.
class TomlTable {
 public:
  /// The text of a whole file; `file` is for messages. Errors: InputError with the line of the mistake.
  static TomlTable parse(std::string_view text, const std::string& file);

  bool has(std::string_view key) const { return table_->contains(key); }
  void expect(std::string_view key) { known(key); }  ///< marks a key as known
  double number(std::string_view key, double otherwise, const Range& range);
  std::int64_t integer(std::string_view key, std::int64_t otherwise, const Range& range);
  bool flag(std::string_view key, bool otherwise);
  std::string text(std::string_view key, std::string_view otherwise);
  void require(std::string_view key, std::string_view expected);  ///< refuses a table without the key
  std::string required_text(std::string_view key, std::string_view expected);
  std::vector<std::string> texts(std::string_view key);
  /// A text, or a list of them that is not empty; refuses a table without the key.
  std::vector<std::string> one_or_more_texts(std::string_view key, std::string_view expected);

  template <class E, std::size_t N>
  E word(std::string_view key, E otherwise, const Word<E> (&words)[N]) {
    if (!has(key)) return known(key), otherwise;
    const std::string given = text(key, {});
    for (const Word<E>& w : words)
      if (w.first == given) return w.second;
    fail(key, "\"" + given + "\" is not known, expected one of " + list_of(words));
  }

  /// [key] as a table; an empty one when it is absent.
  TomlTable table(std::string_view key);
  /// [[key]], one table an entry; a single [key] counts as one entry.
  std::vector<TomlTable> tables(std::string_view key);

  /// Every key of this table in the order of the file.
  std::vector<std::string> keys() const;
  bool is_table(std::string_view key) const;
  bool is_text(std::string_view key) const;

  /// Throws InputError for the first key that no getter asked for, with the nearest one that exists.
  void refuse_unknown() const;

  [[noreturn]] void fail(std::string_view key, std::string_view message) const;
  /// For what a check found: error.key() is a path from here, "mix.equaliser[0].frequency_hz".
  [[noreturn]] void fail(const InvalidField& error) const;
  const std::string& file() const { return *file_; }
  std::string path_of(std::string_view key) const;
  int line_of(std::string_view key) const;  ///< of the table itself when there is no such key

 private:
  TomlTable(std::shared_ptr<const std::string> file, std::shared_ptr<const toml::table> table,
            std::string path);
  const toml::node* known(std::string_view key);

  std::shared_ptr<const std::string> file_;
  std::shared_ptr<const toml::table> table_;  ///< kept alive by the root
  std::string path_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace rigsound::config
