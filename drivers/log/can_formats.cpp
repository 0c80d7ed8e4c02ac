// Which tool wrote a log.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "log/can_capture.hpp"
#include "log/can_lines.hpp"
#include "log/line_reader.hpp"
#include "rigsound/log/can_reader.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr std::size_t kStart = 4096;  // bytes that tell

const std::string kConverter =
    "can_logconvert of python3-can makes a candump log of it: can_logconvert IN OUT.log";

/// A format that is not read: how it begins, and what to do.
struct Foreign {
  std::string_view magic, name;
  std::string_view way_out;  ///< empty: can_logconvert
};
constexpr Foreign kForeign[] = {
    {"LOGG", "a Vector BLF", ""},
    {"MDF     ", "an ASAM MDF (MF4)", ""},
    {"UnFinMF ", "an ASAM MDF (MF4) that was not finished", ""},
    {"SQLite format 3", "a SQLite log of python-can", ""},
    {"timestamp,arbitration_id", "a CSV of python-can", ""},
    {"Time Stamp,ID,Extended", "a CSV of SavvyCAN", "SavvyCAN saves it as a candump log"},
    {"***BUSMASTER", "a BUSMASTER log", "BUSMASTER converts it to ASC"},
    {"\x28\xb5\x2f\xfd", "packed by zstd", "unpack it with unzstd, or send it through zstdcat to --log -"},
    {"\xfd"
     "7zXZ",
     "packed by xz", "unpack it with unxz, or send it through xzcat to --log -"},
    {"BZh", "packed by bzip2", "unpack it with bunzip2, or send it through bzcat to --log -"},
    {"PK\x03\x04", "a zip archive", "unpack it with unzip"},
    {"\xff\xfe", "UTF-16", "iconv -f UTF-16 -t UTF-8 makes it readable"},
    {"\xfe\xff", "UTF-16", "iconv -f UTF-16 -t UTF-8 makes it readable"},
};

std::string start_of(const LogFile& file) {
  std::ifstream in(file.path(), std::ios::binary);
  if (!in) throw InputError(file.name(), "cannot be opened, expected a readable bus log");
  std::string start(kStart, '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(in.gcount()));
  if (start.substr(0, 3) == "\xEF\xBB\xBF") start.erase(0, 3);
  return start;
}

void refuse_foreign(const LogFile& file, const std::string& start) {
  for (const Foreign& foreign : kForeign) {
    if (start.compare(0, foreign.magic.size(), foreign.magic) != 0) continue;
    throw InputError(file.name(), "is " + std::string(foreign.name) +
                                      ", expected a log of candump, ASC, TRC or a capture; " +
                                      (foreign.way_out.empty() ? kConverter : std::string(foreign.way_out)));
  }
}

bool has_line(const std::string& start, std::string_view beginning) {
  return start.compare(0, beginning.size(), beginning) == 0 ||
         start.find("\n" + std::string(beginning)) != std::string::npos;
}

/// candump -t d and -t z look alike, `(000.020000)`: stamps of which some fall, or most stay as they are,
/// count from the frame before, those that grow from the first frame.
CandumpStamps stamps_of(const LogFile& file) {
  constexpr int kEnough = 1000;
  constexpr std::int64_t kMost_ns = 1000 * std::int64_t{1'000'000'000};  // of three digits
  LineReader reader(file, candump_format());
  CanRecord record;
  std::int64_t last_ns = 0;
  int steps = 0, falling = 0, equal = 0;
  for (int n = 0; n < kEnough && reader.next(record); ++n) {
    if ((n == 0 && record.time_ns != 0) || record.time_ns >= kMost_ns) return CandumpStamps::kAbsolute;
    steps += n > 0 ? 1 : 0;
    falling += record.time_ns < last_ns ? 1 : 0;
    equal += n > 0 && record.time_ns == last_ns ? 1 : 0;
    last_ns = record.time_ns;
  }
  const bool gaps = falling * 10 >= steps && falling > 0;
  const bool same_gaps = falling == 0 && steps >= 2 && equal * 2 >= steps;
  return gaps || same_gaps ? CandumpStamps::kSinceLastFrame : CandumpStamps::kAbsolute;
}

/// The log form has ten digits of seconds.
bool has_short_stamps(const std::string& start) {
  const std::size_t open = start.find('(');
  return open != std::string::npos && start.find('.', open) == open + 4;
}

}  // namespace

LogFormat format_of(const LogFile& file) {
  const std::string start = start_of(file);
  if (begins_capture(start)) return LogFormat::kCapture;
  refuse_foreign(file, start);
  if (has_line(start, ";$FILEVERSION") || has_line(start, ";##")) return LogFormat::kTrc;
  if (has_line(start, "base hex") || has_line(start, "base dec")) return LogFormat::kAsc;
  return LogFormat::kCandump;
}

std::unique_ptr<CanReader> open_can_reader(const LogFile& file) {
  switch (format_of(file)) {
    case LogFormat::kCapture:
      return std::make_unique<CanCapture>(file);
    case LogFormat::kAsc:
      return std::make_unique<LineReader>(file, asc_format());
    case LogFormat::kTrc:
      return std::make_unique<LineReader>(file, trc_format());
    case LogFormat::kCandump:
      break;
  }
  const bool short_stamps = has_short_stamps(start_of(file));
  return std::make_unique<LineReader>(
      file, candump_format(short_stamps ? stamps_of(file) : CandumpStamps::kAbsolute));
}

}  // namespace rigsound::log
