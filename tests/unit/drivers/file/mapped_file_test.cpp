#include "rigsound/file/mapped_file.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

constexpr std::size_t kBytes = 4 << 20;

/// Of the mapping that begins there, as the kernel counts.
std::size_t resident_bytes(std::string_view bytes) {
  std::ostringstream begin;
  begin << std::hex << reinterpret_cast<std::uintptr_t>(bytes.data()) << '-';
  std::ifstream mappings("/proc/self/smaps");
  std::string line;
  while (std::getline(mappings, line) && line.rfind(begin.str(), 0) != 0) {
  }
  while (std::getline(mappings, line) && line.rfind("Rss:", 0) != 0) {
  }
  return line.empty() ? 0 : std::stoul(line.substr(4)) * 1024;
}

}  // namespace

TEST_CASE("what a mapped file has forgotten takes no memory and is there when it is looked at again") {
  const test::TemporaryFolder folder;
  std::string text(kBytes, 'a');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>('a' + i / 5000 % 26);
  const MappedFile mapped(folder.write("a", text));
  CHECK(mapped.bytes() == text);
  CHECK(resident_bytes(mapped.bytes()) == kBytes);
  mapped.forget(mapped.bytes().substr(100, kBytes / 2));
  CHECK(resident_bytes(mapped.bytes()) <= kBytes / 2 + 8192);
  CHECK(mapped.bytes() == text);
  mapped.forget(mapped.bytes().substr(0, 0));
  mapped.forget(mapped.bytes().substr(5, 10));
  CHECK(resident_bytes(mapped.bytes()) == kBytes);
}
