#include "log_notes.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {

void print_log_notes(const std::string& file, const log::BusLog& log) {
  for (const std::string& note : log.notes()) fmt::print(stderr, "{}: {}\n", file, note);
}

}  // namespace rigsound::tools
