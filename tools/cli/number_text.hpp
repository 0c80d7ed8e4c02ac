// Numbers as people type them on a command line. Thread: OFF.
#pragma once

#include <cstdint>
#include <string>

namespace rigsound::cli {

/// What is wrong with `text`, and what was expected; empty when all of it is a finite number, or a whole
/// number that the type holds (0x starts a hexadecimal one).
std::string number_fault(const std::string& text);
std::string int32_fault(const std::string& text);
std::string uint32_fault(const std::string& text);
std::string uint64_fault(const std::string& text);

/// As number_fault(); also outside low...high, which the message calls `accepted`.
std::string range_fault(const std::string& text, double low, double high, const std::string& accepted);

/// The number that a text without a fault stands for.
double number_of(const std::string& text);
std::int64_t integer_of(const std::string& text);
std::uint64_t unsigned_of(const std::string& text);

std::string number_text(
    double value);  ///< the shortest that reads as this value, six digits of what is no whole number

}  // namespace rigsound::cli
