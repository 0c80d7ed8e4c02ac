#include "log_notes.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {

void print_log_notes(const std::string& file, const log::BusLog& log) {
  for (const log::LogNote& note : log.notes()) {
    const std::string where = note.line > 0 ? fmt::format("{}:{}", file, note.line) : file;
    fmt::print(stderr, "{}: {}\n", where, note.text);
  }
}

}  // namespace rigsound::tools
