// Writes the fields of a struct as keys of a TOML table; an archive of rigsound/machine/fields.hpp.
#pragma once

#include <string>

#include "rigsound/machine/fields.hpp"

namespace rigsound::config {

class TomlWriter {
 public:
  template <class Number>
  void operator()(const char* key, Number x, const Range&) {
    line(key, number_text(static_cast<double>(x)));
  }
  template <class E, std::size_t N>
  void operator()(const char* key, E value, const Word<E> (&words)[N]) {
    for (const Word<E>& word : words)
      if (word.second == value) line(key, "\"" + std::string(word.first) + "\"");
  }
  void operator()(const char* key, const std::string& text) { line(key, "\"" + text + "\""); }

  const std::string& text() const { return text_; }

 private:
  void line(const char* key, const std::string& value) { text_ += std::string(key) + " = " + value + "\n"; }

  std::string text_;
};

/// `key = value`, one a line, in the order of the list.
template <class Options>
std::string toml_text(const Options& options) {
  TomlWriter writer;
  visit(writer, options);
  return writer.text();
}

}  // namespace rigsound::config
