// Logs as they lie on disk: plain, or packed by gzip, whole or cut off.
#include "rigsound/log/log_file.hpp"

#include <doctest/doctest.h>
#include <zlib.h>

#include <filesystem>
#include <string>

#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::log;

namespace {

void gzip_to(const std::filesystem::path& file, const std::string& text) {
  const gzFile out = ::gzopen(file.c_str(), "wb");
  REQUIRE(out != nullptr);
  if (!text.empty()) CHECK(::gzwrite(out, text.data(), static_cast<unsigned>(text.size())) > 0);
  ::gzclose(out);
}

std::string lines_of_log(std::size_t bytes) {
  std::string text;
  for (int i = 0; text.size() < bytes; ++i)
    text += "(" + std::to_string(i) + ".0) can0 123#" + std::to_string(10 + i % 80) + "\n";
  text.resize(bytes);
  return text;
}

}  // namespace

TEST_CASE("a log that gzip packed is read as what it was, of any length") {
  const test::TemporaryFolder folder;
  for (const std::size_t bytes : {0, 1, 65535, 65536, 65537, 300000}) {
    CAPTURE(bytes);
    const std::string text = lines_of_log(bytes);
    gzip_to(folder.path / "log.gz", text);
    const LogFile packed(folder.path / "log.gz");
    CHECK(packed.name() == (folder.path / "log.gz").string());
    CHECK(test::content(packed.path()) == text);
    CHECK(packed.bytes() == bytes);
    const LogFile plain(folder.write("log", text));
    CHECK(test::content(plain.path()) == text);
    CHECK(plain.bytes() == bytes);
  }
}

TEST_CASE("a packed log that was cut off or damaged is refused, wherever that is") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "log.gz";
  const std::string text = lines_of_log(200000);
  gzip_to(file, text);
  const std::string whole = test::content(file);
  for (const std::size_t size : {whole.size() - 1, whole.size() - 9, whole.size() / 2, std::size_t{20}}) {
    CAPTURE(size);
    folder.write("log.gz", whole.substr(0, size));
    CHECK(test::complaint([&] {
            const LogFile log(file);
          }).rfind(file.string() + ": cannot be unpacked to its end: ", 0) == 0);
  }
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 0x55);
  folder.write("log.gz", damaged);
  CHECK_THROWS_AS(LogFile{file}, InputError);
}

TEST_CASE("what has been read of a log is a share of it, all of one whose length is not known") {
  CHECK(share_of(0, 100) == 0);
  CHECK(share_of(25, 100) == 0.25);
  CHECK(share_of(100, 100) == 1);
  CHECK(share_of(7, 0) == 1);
}
