// Writes the fields of a struct into a JSON object; an archive of rigsound/machine/fields.hpp.
#pragma once

#include <complex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "rigsound/diesel_model.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::config {

/// Keys in the order of the list. Numbers are rounded as their ranges say, others come back exactly.
class JsonWriter {
 public:
  explicit JsonWriter(nlohmann::ordered_json& out) : out_(out) {}

  template <class Options>
  void write(const Options& options) {
    visit(*this, options);
  }

  void operator()(const char* key, const double& x, const Range& range);
  void operator()(const char* key, const int& x, const Range& range);
  void operator()(const char* key, const bool& on);
  void operator()(const char* key, const std::string& text);
  void operator()(const char* key, const Allpass& allpass, const Range& range);
  void operator()(const char* key, const std::vector<float>& list, const Range& range);
  void operator()(const char* key, const std::vector<float>& powers, const PowersInDb& kept);
  void operator()(const char* level_key, const char* phase_key,
                  const std::vector<std::complex<float>>& orders, const Range& levels, const Range& phases);

  template <class E, std::size_t N>
  void operator()(const char* key, const E& value, const Word<E> (&words)[N]) {
    for (const Word<E>& word : words)
      if (word.second == value) (*this)(key, std::string(word.first));
  }

  template <class Item>
  void operator()(const char* key, const std::vector<Item>& list) {
    nlohmann::ordered_json& array = child(key, Kind::kList);
    for (const Item& item : list) JsonWriter(next_item(array)).write(item);
  }

  template <class Options>
  void operator()(const char* key, const Options& options) {
    JsonWriter(child(key, Kind::kObject)).write(options);
  }

 private:
  enum class Kind : std::uint8_t { kObject, kList };
  nlohmann::ordered_json& child(const char* key, Kind kind);
  static nlohmann::ordered_json& next_item(nlohmann::ordered_json& list);

  nlohmann::ordered_json& out_;
};

/// Objects over several lines, lists of numbers on one: a spectrum is one line. Ends with a newline; bytes
/// that are no UTF-8 are replaced.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace rigsound::config
