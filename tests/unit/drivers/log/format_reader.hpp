// A text format of CAN logs that has read some lines before.
#pragma once

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "log/can_lines.hpp"

namespace rigsound::test {

inline std::vector<int> bytes(const can::Frame& frame) {
  return {frame.data.begin(), frame.data.begin() + frame.size};
}

struct FormatReader {
  explicit FormatReader(std::unique_ptr<log::CanLineFormat> which,
                        const std::vector<std::string>& before = {})
      : format(std::move(which)) {
    log::CanRecord ignored;
    for (const std::string& line : before) format->parse(line, ignored);
  }
  log::CanRecord frame(std::string_view line) const {
    log::CanRecord record;
    CAPTURE(std::string(line));
    REQUIRE(format->parse(line, record) == log::CanLine::kFrame);
    return record;
  }
  bool other(std::string_view line) const {
    log::CanRecord record;
    return format->parse(line, record) == log::CanLine::kOther;
  }
  std::unique_ptr<log::CanLineFormat> format;
};

}  // namespace rigsound::test
