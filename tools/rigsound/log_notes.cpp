#include "log_notes.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigsound::tools {
namespace {

std::string text_of(const log::Refusal& refusal, const config::Rig& rig) {
  const SignalInfo& signal = info(refusal.id.signal);
  const std::string label = config::signal_label(rig, refusal.id);
  if (refusal.why != Validity::kOutOfRange)
    return fmt::format("{}: {} readings were no value: {}", label, refusal.count, name(refusal.why));
  return fmt::format("{}: {} readings were refused, the last {:g}, expected {:g}...{:g}{}{}", label,
                     refusal.count, refusal.last, signal.min, signal.max, signal.unit.empty() ? "" : " ",
                     signal.unit);
}

}  // namespace

void print_log_notes(const std::string& file, const log::BusLog& log, const config::Rig& rig) {
  for (const log::LogNote& note : log.notes())
    fmt::print(stderr, "{}{}: {}\n", file, note.line > 0 ? ":" + std::to_string(note.line) : "", note.text);
  for (const log::Refusal& refusal : log.refusals())
    fmt::print(stderr, "{}: {}\n", file, text_of(refusal, rig));
}

}  // namespace rigsound::tools
