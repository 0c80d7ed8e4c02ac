#include "cli/number_text.hpp"

#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace rigsound::cli {
namespace {

bool whole(const std::string& text, const char* end) {
  return !text.empty() && std::isspace(static_cast<unsigned char>(text.front())) == 0 &&
         end == text.c_str() + text.size();
}

bool is_number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return whole(text, end) && std::isfinite(value);
}

bool between(const std::string& text, std::int64_t low, std::int64_t high) {
  char* end = nullptr;
  errno = 0;
  const std::int64_t value = std::strtoll(text.c_str(), &end, 0);
  return whole(text, end) && errno == 0 && value >= low && value <= high;
}

std::string not_from_zero(const std::string& text) {
  return "'" + text + "' is no whole number from 0 on, expected one such as 2";
}

}  // namespace

std::string number_fault(const std::string& text) {
  if (is_number(text)) return {};
  std::string with_point = text;
  if (const std::size_t comma = text.find(','); comma != std::string::npos) with_point[comma] = '.';
  return "'" + text + "' is no number, expected " +
         (with_point != text && is_number(with_point) ? "a decimal point: " + with_point : "one such as 0.5");
}

std::string int32_fault(const std::string& text) {
  return between(text, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max())
             ? std::string()
             : "'" + text + "' is no whole number, expected one such as 2";
}

std::string uint32_fault(const std::string& text) {
  return between(text, 0, std::numeric_limits<std::uint32_t>::max()) ? std::string() : not_from_zero(text);
}

std::string uint64_fault(const std::string& text) {
  char* end = nullptr;
  errno = 0;
  std::strtoull(text.c_str(), &end, 0);
  return whole(text, end) && errno == 0 && text.front() != '-' ? std::string() : not_from_zero(text);
}

std::string range_fault(const std::string& text, double low, double high, const std::string& accepted) {
  if (std::string fault = number_fault(text); !fault.empty()) return fault;
  const double value = number_of(text);
  return value >= low && value <= high ? std::string() : "is " + text + ", expected " + accepted;
}

double number_of(const std::string& text) { return std::strtod(text.c_str(), nullptr); }
std::int64_t integer_of(const std::string& text) { return std::strtoll(text.c_str(), nullptr, 0); }
std::uint64_t unsigned_of(const std::string& text) { return std::strtoull(text.c_str(), nullptr, 0); }

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value == std::floor(value) && std::fabs(value) < 1e15 ? "%.0f" : "%g",
                value);
  return text;
}

}  // namespace rigsound::cli
