// Reads back what PackWriter wrote, mistrusting every byte; an archive of rigsound/machine/fields.hpp.
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/diesel_model.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::config {

constexpr std::uint32_t kPackVersion = 2;  ///< 2: [mix] lookahead_ms

class PackReader {
 public:
  /// `bytes` must outlive it; `file` is for messages. What a file of `version` does not hold stays as it is.
  PackReader(std::string_view bytes, const std::string& file, std::uint32_t version = kPackVersion)
      : bytes_(bytes), file_(file), version_(version) {}

  [[noreturn]] void fail(const std::string& problem) const { throw InputError(file_, problem); }
  std::size_t left() const noexcept { return bytes_.size() - at_; }
  std::size_t position() const noexcept { return at_; }

  template <class Number>
  Number number() {
    Number x;
    std::memcpy(&x, take(sizeof x), sizeof x);
    return x;
  }
  /// A count of things that take at least `bytes_each`.
  std::size_t size(std::size_t bytes_each) {
    const auto count = number<std::uint32_t>();
    if (count > left() / bytes_each) fail("is damaged: it is too short for what it says it holds");
    return count;
  }
  std::string text() {
    const std::size_t count = size(1);
    return std::string(take(count), count);
  }
  template <class Sample>
  void samples(std::vector<Sample>& list) {
    list.resize(size(sizeof(Sample)));
    if (!list.empty())
      std::memcpy(static_cast<void*>(list.data()), take(list.size() * sizeof(Sample)),
                  list.size() * sizeof(Sample));
  }

  template <class Options>
  void read(Options& options) {
    fields(*this, options);
  }

  void operator()(const char* key, double& x, const Range& range) {
    if (version_ < 2 && std::string_view(key) == "lookahead_s") return;
    x = number<double>();
    if (!range.holds(x)) fail(key, range.problem(x));
  }
  void operator()(const char* key, int& x, const Range& range) {
    x = number<std::int32_t>();
    if (!range.holds(x)) fail(key, range.problem(x));
  }
  void operator()(const char*, bool& on) { on = number<std::uint8_t>() != 0; }
  void operator()(const char*, std::string& x) { x = text(); }
  void operator()(const char*, std::string& x, Label) { x = text(); }
  void operator()(const char*, std::vector<float>& list, const Range&) { samples(list); }
  void operator()(const char*, std::vector<float>& powers, const PowersInDb&) { samples(powers); }
  void operator()(const char*, const char*, std::vector<std::complex<float>>& orders, const Range&,
                  const Range&) {
    samples(orders);
  }
  void operator()(const char* key, Allpass& allpass, const Range&) {
    const std::size_t sections = size(2 * sizeof(double));
    if (sections > allpass.section.size())
      fail(key, "has " + std::to_string(sections) + " sections, expected fewer");
    allpass.sections = static_cast<int>(sections);
    for (std::size_t i = 0; i < sections; ++i) allpass.section[i] = {number<double>(), number<double>()};
    allpass.first_orders = number<std::int32_t>(), allpass.a = number<double>();
  }

  template <class E, std::size_t N>
  void operator()(const char* key, E& value, const Word<E> (&words)[N]) {
    const std::string given = text();
    const auto found =
        std::find_if(words, words + N, [&](const Word<E>& word) { return word.first == given; });
    if (found == words + N) fail(key, "is \"" + given + "\", expected one of " + list_of(words));
    value = found->second;
  }
  template <class Item>
  void operator()(const char*, std::vector<Item>& list) {
    for (std::size_t left = size(1); left > 0; --left) read(list.emplace_back());
  }
  template <class Options>
  void operator()(const char*, Options& options) {
    read(options);
  }

 private:
  [[noreturn]] void fail(const char* key, const std::string& problem) const {
    throw InputError(file_, 0, key, problem);
  }
  const char* take(std::size_t count) {
    if (count > left()) fail("is cut off or damaged: it is too short for what it says it holds");
    const char* const from = bytes_.data() + at_;
    at_ += count;
    return from;
  }

  std::string_view bytes_;
  const std::string& file_;
  std::uint32_t version_;
  std::size_t at_ = 0;
};

}  // namespace rigsound::config
