#include "dbc/dbc_codes.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace rigsound::config {
namespace {

/// Small letters and nothing else: "Not available (SNA)" is "notavailablesna".
std::string letters(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c >= 'a' && c <= 'z') out += c;
    if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

template <std::size_t N>
bool begins_with_one_of(const std::string& text, const std::array<std::string_view, N>& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return text.compare(0, word.size(), word) == 0; });
}

template <std::size_t N>
bool ends_with_one_of(const std::string& text, const std::array<std::string_view, N>& words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return text.size() >= word.size() && text.compare(text.size() - word.size(), word.size(), word) == 0;
  });
}

constexpr std::array<std::string_view, 8> kMissing = {"notavail",       "sna",         "unavailable",
                                                      "signalnotavail", "dontcare",    "donotcare",
                                                      "takenoaction",   "notinstalled"};
constexpr std::array<std::string_view, 6> kWrong = {"error",    "fault",    "invalid",
                                                    "notvalid", "reserved", "undefined"};
constexpr std::array<std::string_view, 3> kWrongAtEnd = {"error", "fault", "invalid"};
constexpr std::array<std::string_view, 2> kDenials = {"noerror", "nofault"};

Validity meaning(const std::string& text) {
  const std::string word = letters(text);
  if (begins_with_one_of(word, kMissing) || word == "na") return Validity::kNotAvailable;
  if (ends_with_one_of(word, kDenials)) return Validity::kValid;
  if (begins_with_one_of(word, kWrong) || ends_with_one_of(word, kWrongAtEnd)) return Validity::kErrorValue;
  return Validity::kValid;
}

}  // namespace

std::vector<can::RawCode> raw_codes(const DbcSignal& signal) {
  const int length = signal.layout.field.length;
  const std::uint64_t bits = length >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << length) - 1;
  std::vector<can::RawCode> codes;
  for (const auto& [raw, text] : signal.values)
    codes.push_back({static_cast<std::uint64_t>(raw) & bits, meaning(text)});
  return codes;
}

}  // namespace rigsound::config
