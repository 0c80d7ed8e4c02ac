// Which tool wrote a log, and how the stamps of a candump screen count.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/log/can_reader.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::log;

namespace {

LogFormat format_of_text(std::string_view text) {
  const test::TemporaryFolder folder;
  return format_of(LogFile(folder.write("log", text)));
}

std::string refusal(std::string_view text) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("log", text);
  const std::string said = test::complaint([&] { format_of(LogFile(file)); });
  return said.empty() ? said : said.substr(file.string().size() + 2);
}

/// Times of all frames in ms.
std::vector<double> times_ms(const std::vector<const char*>& stamps) {
  std::string text;
  for (const char* stamp : stamps) text += " (" + std::string(stamp) + ")  can0  123   [1]  00\n";
  const test::TemporaryFolder folder;
  const LogFile file(folder.write("log", text));
  const auto reader = open_can_reader(file);
  std::vector<double> times;
  for (CanRecord record; reader->next(record);) times.push_back(static_cast<double>(record.time_ns) * 1e-6);
  CHECK(reader->counts().other == 0);
  return times;
}

using Times = std::vector<double>;

}  // namespace

TEST_CASE("A log is known by how it begins, or by a line of its header") {
  CHECK(format_of_text("") == LogFormat::kCandump);
  CHECK(format_of_text("(1.0) can0 123#00\n") == LogFormat::kCandump);
  CHECK(format_of_text(";$FILEVERSION=2.1\n") == LogFormat::kTrc);
  CHECK(format_of_text("\xEF\xBB\xBF;$FILEVERSION=2.1\n") == LogFormat::kTrc);
  CHECK(format_of_text("; a comment\n;$FILEVERSION=2.1\n") == LogFormat::kTrc);
  CHECK(format_of_text(";##########\n") == LogFormat::kTrc);
  CHECK(format_of_text("base hex  timestamps absolute\n") == LogFormat::kAsc);
  CHECK(format_of_text("date Wed\nbase dec  timestamps absolute\n") == LogFormat::kAsc);
  CHECK(format_of_text("date Wed\nbase hex  timestamps absolute\n") == LogFormat::kAsc);
  CHECK(format_of_text("a base hex\n") == LogFormat::kCandump);  // not at the start of a line
  for (const char* magic :
       {"\xd4\xc3\xb2\xa1", "\xa1\xb2\xc3\xd4", "\x4d\x3c\xb2\xa1", "\xa1\xb2\x3c\x4d", "\x0a\x0d\x0d\x0a"})
    CHECK(format_of_text(std::string(magic) + "rest") == LogFormat::kCapture);
}

TEST_CASE("A format that is not read is refused with its name and what makes it readable") {
  CHECK(refusal("LOGG....") ==
        "is a Vector BLF, expected a log of candump, ASC, TRC or a capture; can_logconvert of python3-can "
        "makes a candump log of it: can_logconvert IN OUT.log");
  CHECK(refusal("BZh91AY").find("is packed by bzip2, ") == 0);
  CHECK(refusal("BZh91AY").find("; unpack it with bunzip2, or send it through bzcat to --log -") !=
        std::string::npos);
  CHECK(refusal("***BUSMASTER Ver 3***").find("; BUSMASTER converts it to ASC") != std::string::npos);
  CHECK(refusal("\xff\xfeL\n").find("is UTF-16, ") == 0);
  CHECK(refusal("LOG").empty());
  CHECK(refusal("xLOGG").empty());
}

TEST_CASE("Stamps of the screen that only grow count from the first frame, or from 1970") {
  CHECK(times_ms({"000.000000", "000.020000", "000.040000"}) == Times{0, 20, 40});
  CHECK(times_ms({"000.000000", "000.020000", "000.020000", "000.040000"}) == Times{0, 20, 20, 40});
  CHECK(times_ms({"1.000000", "0.500000"}) == Times{1000, 500});
  CHECK(times_ms({"1557265716.000000", "1557265716.020000"}) == Times{1557265716000, 1557265716020});
  CHECK(times_ms({"000.000000"}) == Times{0});
  CHECK(times_ms({"000.000000", "000.000000"}) == Times{0, 0});
}

TEST_CASE("Stamps of the screen of which some fall, or most stay, count from the frame before") {
  CHECK(times_ms({"000.000000", "000.020000", "000.010000", "000.030000"}) == Times{0, 20, 30, 60});
  CHECK(times_ms({"000.000000", "000.020000", "000.020000", "000.020000"}) == Times{0, 20, 40, 60});
  CHECK(times_ms({"000.000000", "000.020000", "000.020000", "000.030000", "000.030000"}) ==
        Times{0, 20, 40, 70, 100});  // half of them stay
  CHECK(times_ms({"000.000000", "000.020000", "000.020000", "000.030000", "000.040000"}) ==
        Times{0, 20, 20, 30, 40});  // a quarter does
}

TEST_CASE("One stamp of many that falls is a clock that was set, not a gap") {
  std::vector<std::string> stamps;
  for (int i = 0; i < 40; ++i)
    stamps.push_back(i == 20 ? "000.001000" : "000." + std::to_string(100 + i) + "000");
  stamps[0] = "000.000000";
  std::vector<const char*> texts;
  for (const std::string& stamp : stamps) texts.push_back(stamp.c_str());
  const Times times = times_ms(texts);
  REQUIRE(times.size() == 40);
  CHECK(times[1] == doctest::Approx(101));
  CHECK(times[20] == doctest::Approx(1));
  CHECK(times[39] == doctest::Approx(139));
}

TEST_CASE("Only stamps of three digits may be gaps") {
  CHECK(times_ms({"0000000000.000000", "0000000000.020000", "0000000000.010000"}) == Times{0, 20, 10});
  CHECK(times_ms({"00.000000", "00.020000", "00.010000"}) == Times{0, 20, 10});
  CHECK(times_ms({"0000.000000", "0000.020000", "0000.010000"}) == Times{0, 20, 10});
}

TEST_CASE("A log that begins late, or reaches over 1000 s, has no gaps for stamps") {
  CHECK(times_ms({"000.500000", "000.020000", "000.010000"}) == Times{500, 20, 10});
  CHECK(times_ms({"000.000000", "1000.000000", "000.010000"}) == Times{0, 1000000, 10});
}
