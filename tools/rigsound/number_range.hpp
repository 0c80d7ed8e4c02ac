// Ranges of numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>

namespace rigsound::tools {

/// CLI::Range with "nan" refused: it lets it through, since every comparison with it is false.
inline CLI::Validator number_between(double low, double high) {
  CLI::Validator range = CLI::Range(low, high);
  CLI::Validator number(
      [](const std::string& text) {
        const double value = std::strtod(text.c_str(), nullptr);
        return value == value ? std::string() : "'" + text + "' is no number";
      },
      "");
  return range & number;
}

}  // namespace rigsound::tools
