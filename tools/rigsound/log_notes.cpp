#include "log_notes.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {

void print_log_notes(const std::string& file, const log::BusLog& log) {
  for (const log::LogNote& note : log.notes())
    fmt::print(stderr, "{}{}: {}\n", file, note.line > 0 ? ":" + std::to_string(note.line) : "", note.text);
}

}  // namespace rigsound::tools
