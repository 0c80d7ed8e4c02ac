#include "log_notes.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "rigsound/input_error.hpp"

namespace rigsound::tools {

void require_can(const config::Rig& rig) {
  if (rig.can.empty())
    throw InputError(rig.file.string(), 0, "can",
                     "is missing, expected a [[can]] with interface, dbc and signals");
}

void print_log_notes(const std::string& file, const log::CanLog& log) {
  const log::CandumpCounts& counts = log.counts();
  fmt::print(stderr, "{}: {} frames in {:.1f} s, {} used\n", file, counts.frames, log.length_s(), log.used());
  if (counts.other + counts.xl > 0)
    fmt::print(stderr, "{}: skipped {} lines that are no frame and {} CAN XL frames\n", file, counts.other,
               counts.xl);
  if (counts.error_frames > 0) fmt::print(stderr, "{}: {} error frames\n", file, counts.error_frames);
  if (counts.backwards > 0)
    fmt::print(stderr,
               "{}:{}: time runs backwards here (and {} times in all); kept in the order of the file\n", file,
               counts.first_backwards_line, counts.backwards);
}

}  // namespace rigsound::tools
