// What the lists of options are written with. Beside each struct of options stands one
//
//   template <class Archive>
//   void fields(Archive& a, SceneOptions& o) {
//     a("contact_bar", o.contact_bar, Range{0, 300, "bar"});
//
// and whatever reads, writes, checks or compares those options visits it: a number's range stands there and
// nowhere else. An archive is called with a key and a reference, and for
//   a number                  Range
//   a word that means a value an array of Word
//   a text that only names    Label
// Other texts, truth values, structs with a list of their own and vectors of those go by themselves.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace rigsound {

/// The values a number may have, both ends included.
struct Range {
  double min = 0, max = 0;
  const char* unit = "";
  double step = 0;    ///< values are whole multiples of it; 0: any
  bool zero = false;  ///< 0 may stand for "none" too
  int decimals = -1;  ///< a file keeps so many; negative: all

  constexpr Range multiples_of(double count) const { return {min, max, unit, count, zero, decimals}; }
  constexpr Range whole() const { return multiples_of(1); }
  constexpr Range or_zero() const { return {min, max, unit, step, true, decimals}; }
  constexpr Range rounded(int digits) const { return {min, max, unit, step, zero, digits}; }

  bool holds(double x) const noexcept;  ///< never for NaN

  std::string text() const;  ///< "0.001...10 s", "0 or 5...120 Hz", "32...64 frames, a multiple of 32"
  std::string problem(double x) const;  ///< "is 12 s, expected 0.001...10 s"
};

/// Ten digits at most, as people write them: 0.001, 1e-12, 48000.
std::string number_text(double x);

/// A word of a file and the value it stands for.
template <class E>
using Word = std::pair<std::string_view, E>;

/// "server", then "server, client"
inline void append_to_list(std::string& list, std::string_view word) {
  list.append(list.empty() ? "" : ", ").append(word);
}

/// "server, client"
template <class E, std::size_t N>
std::string list_of(const Word<E> (&words)[N]) {
  std::string list;
  for (const Word<E>& word : words) append_to_list(list, word.first);
  return list;
}

template <class Texts>
std::string list_of(const Texts& texts) {
  std::string list;
  for (const std::string_view text : texts) append_to_list(list, text);
  return list;
}

/// Marks a text that is a name for people: nothing depends on it.
struct Label {};

/// A value that cannot be used: what() is `KEY: is X, expected Y`, behind `where` when there is one, such as
/// `bank "a": `. Thread: OFF, CT.
class InvalidField : public std::invalid_argument {
 public:
  InvalidField(const std::string& where, std::string key, std::string problem)
      : std::invalid_argument(where + key + ": " + problem),
        key_(std::move(key)),
        problem_(std::move(problem)) {}

  const std::string& key() const noexcept {
    return key_;
  }  ///< path from the visited struct: "scene.idle_rpm"
  const std::string& problem() const noexcept { return problem_; }

 private:
  std::string key_, problem_;
};

/// Visits the list of options that stay as they are: `archive` takes every reference as const.
template <class Archive, class Options>
void visit(Archive& archive, const Options& options) {
  fields(archive, const_cast<Options&>(options));
}

}  // namespace rigsound
