// Writes the fields of a struct as bytes, in the order of their list; an archive of
// rigsound/machine/fields.hpp.
#pragma once

#include <complex>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "rigsound/diesel_model.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::config {

class PackWriter {
 public:
  explicit PackWriter(std::string& out) : out_(out) {}

  /// Little-endian, as the machines are that this runs on.
  template <class Number>
  void number(Number x) {
    static_assert(std::is_arithmetic_v<Number>);
    out_.append(reinterpret_cast<const char*>(&x), sizeof x);
  }
  void size(std::size_t count) { number(static_cast<std::uint32_t>(count)); }
  void text(const std::string& text) {
    size(text.size());
    out_ += text;
  }
  template <class Sample>
  void samples(const std::vector<Sample>& list) {
    size(list.size());
    out_.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Sample));
  }

  template <class Options>
  void write(const Options& options) {
    visit(*this, options);
  }

  void operator()(const char*, const double& x, const Range&) { number(x); }
  void operator()(const char*, const int& x, const Range&) { number(static_cast<std::int32_t>(x)); }
  void operator()(const char*, const bool& on) { number(static_cast<std::uint8_t>(on)); }
  void operator()(const char*, const std::string& x) { text(x); }
  void operator()(const char*, const std::string& x, Label) { text(x); }
  void operator()(const char*, const std::vector<float>& list, const Range&) { samples(list); }
  void operator()(const char*, const std::vector<float>& powers, const PowersInDb&) { samples(powers); }
  void operator()(const char*, const char*, const std::vector<std::complex<float>>& orders, const Range&,
                  const Range&) {
    samples(orders);
  }
  void operator()(const char*, const Allpass& allpass, const Range&) {
    size(static_cast<std::size_t>(allpass.sections));
    for (int i = 0; i < allpass.sections; ++i) number(allpass.section[i].b), number(allpass.section[i].c);
    number(static_cast<std::int32_t>(allpass.first_orders)), number(allpass.a);
  }

  template <class E, std::size_t N>
  void operator()(const char*, const E& value, const Word<E> (&words)[N]) {
    for (const Word<E>& word : words)
      if (word.second == value) text(std::string(word.first));
  }
  template <class Item>
  void operator()(const char*, const std::vector<Item>& list) {
    size(list.size());
    for (const Item& item : list) write(item);
  }
  template <class Options>
  void operator()(const char*, const Options& options) {
    write(options);
  }

 private:
  std::string& out_;
};

}  // namespace rigsound::config
