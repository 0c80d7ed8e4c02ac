// How every check of the engine says no.
#pragma once

#include <complex>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/diesel_model.hpp"
#include "rigsound/machine/fields.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound {

/// Holds options and models against their lists. Throws InvalidField. Thread: OFF.
class FieldCheck {
 public:
  /// `where` begins each message, such as `bank "a": `; `path` is that of the checked struct, "scene.".
  explicit FieldCheck(std::string where = {}, std::string path = {})
      : where_(std::move(where)), path_(std::move(path)) {}

  /// Every number of the list is in its range; NaN is in none.
  template <class Options>
  void ranges(const Options& options) const {
    visit(*this, options);
  }

  /// For what depends on several numbers; `problem` as `is X, expected Y`.
  void require(bool holds, std::string_view key, std::string_view problem) const;

  /// A limit that another number sets: `name` says which, "2 T0".
  void at_most(double limit, std::string_view name, double x, std::string_view key) const;

  FieldCheck inside(const std::string& key) const { return FieldCheck(where_, path_ + key + "."); }
  FieldCheck inside(const std::string& list, std::size_t index) const;

  // The archive's part.
  void operator()(const char* key, const double& x, const Range& range) const { hold(key, x, range); }
  void operator()(const char* key, const int& x, const Range& range) const { hold(key, x, range); }
  void operator()(const char* key, const Allpass& allpass, const Range& range) const;
  void operator()(const char* key, const std::vector<float>& list, const Range& range) const;
  void operator()(const char* key, const std::vector<float>& powers, const PowersInDb& kept) const;
  void operator()(const char* level_key, const char* phase_key,
                  const std::vector<std::complex<float>>& orders, const Range& levels,
                  const Range& phases) const;
  void operator()(const char*, const std::string&, Label = {}) const {}
  void operator()(const char*, const bool&) const {}
  template <class E, std::size_t N>
  void operator()(const char*, const E&, const Word<E> (&)[N]) const {}

  template <class Item>
  void operator()(const char* key, const std::vector<Item>& list) const {
    for (std::size_t i = 0; i < list.size(); ++i) inside(key, i).ranges(list[i]);
  }
  template <class Options>
  void operator()(const char* key, const Options& options) const {
    inside(key).ranges(options);
  }

 private:
  void hold(std::string_view key, double x, const Range& range) const;

  std::string where_, path_;
};

}  // namespace rigsound
