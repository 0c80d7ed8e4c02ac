#include "background/table.hpp"

#include <cstdio>

namespace rigsound::bench {
namespace {

void row(const std::string& what, const std::string& wanted, double reached, const char* unit,
         const char* verdict) {
  std::printf("| %-58s | %10s | %9.3g %-6s | %s |\n", what.c_str(), wanted.c_str(), reached, unit, verdict);
  std::fflush(stdout);
}

std::string bound(const char* sign, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%s %.3g", sign, value);
  return text;
}

}  // namespace

Table::Table() {
  std::printf("| %-58s | %10s | %-16s | %-6s |\n", "what", "wanted", "reached", "");
  std::printf("| --- | --- | --- | --- |\n");
}

void Table::at_most(const std::string& what, double wanted, double reached, const char* unit) {
  const bool ok = reached <= wanted;
  held_ = held_ && ok;
  row(what, bound("<=", wanted), reached, unit, ok ? "held" : "MISSED");
}

void Table::at_least(const std::string& what, double wanted, double reached, const char* unit) {
  const bool ok = reached >= wanted;
  held_ = held_ && ok;
  row(what, bound(">=", wanted), reached, unit, ok ? "held" : "MISSED");
}

void Table::note(const std::string& what, double reached, const char* unit) const {
  row(what, "", reached, unit, "");
}

void Table::skip(const std::string& what, const std::string& reason) const {
  std::printf("SKIPPED: %s: %s\n", what.c_str(), reason.c_str());
}

}  // namespace rigsound::bench
