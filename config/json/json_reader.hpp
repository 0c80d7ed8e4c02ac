// Reads the fields of a struct from a JSON object; an archive of rigsound/machine/fields.hpp.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "json/json_file.hpp"
#include "rigsound/diesel_model.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::config {

/// kAll: a program writes the file, every key must be there and others are passed over. kSome: people edit
/// it, a key left out keeps its default and unknown ones are refused.
enum class JsonKeys : std::uint8_t { kAll, kSome };

class JsonReader {
 public:
  /// `known` are keys of the object that belong to no field.
  JsonReader(const JsonFile& in, JsonKeys keys, std::vector<std::string> known = {})
      : in_(in), keys_(keys), known_(std::move(known)) {}

  template <class Options>
  void read(Options& options) {
    fields(*this, options);
    refuse_unknown();
  }

  void operator()(const char* key, double& x, const Range& range);
  void operator()(const char* key, int& x, const Range& range);
  void operator()(const char* key, bool& on);
  void operator()(const char* key, std::string& text);
  void operator()(const char* key, Allpass& allpass, const Range& range);
  void operator()(const char* key, std::vector<float>& list, const Range& range);
  void operator()(const char* key, std::vector<float>& powers, const PowersInDb& kept);
  void operator()(const char* level_key, const char* phase_key, std::vector<std::complex<float>>& orders,
                  const Range& levels, const Range& phases);

  template <class E, std::size_t N>
  void operator()(const char* key, E& value, const Word<E> (&words)[N]) {
    if (!wanted(key)) return;
    const std::string given = in_.text(key);
    const auto found =
        std::find_if(words, words + N, [&](const Word<E>& word) { return word.first == given; });
    if (found == words + N) in_.fail(key, "is \"" + given + "\", expected one of " + list_of(words));
    value = found->second;
  }

  template <class Item>
  void operator()(const char* key, std::vector<Item>& list) {
    if (!wanted(key)) return;
    for (const JsonFile& item : in_.objects(key)) JsonReader(item, keys_).read(list.emplace_back());
  }

  template <class Options>
  void operator()(const char* key, Options& options) {
    if (wanted(key)) JsonReader(in_.object(key), keys_).read(options);
  }

 private:
  bool wanted(const char* key);
  void refuse_unknown() const;

  JsonFile in_;
  JsonKeys keys_;
  std::vector<std::string> known_;
};

}  // namespace rigsound::config
