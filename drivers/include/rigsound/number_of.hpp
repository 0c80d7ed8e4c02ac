// A text that is a number and nothing else.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace rigsound {

/// The number that `text` is from its first letter to its last, as std::from_chars reads it; `base` is a
/// whole number's. Nothing when a letter is left over, or when a `Number` cannot hold it. Thread: OFF.
template <class Number, class... Base>
std::optional<Number> number_of(std::string_view text, Base... base) {
  Number x{};
  const char* const behind = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), behind, x, base...);
  return error == std::errc() && end == behind ? std::optional<Number>(x) : std::nullopt;
}

}  // namespace rigsound
