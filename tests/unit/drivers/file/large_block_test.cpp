#include "rigsound/file/large_block.hpp"

#include <doctest/doctest.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

constexpr std::size_t kPiece = LargeBlock::kPiece;

bool is_there(char* page) {
  unsigned char resident = 0;
  return ::mincore(page, 1, &resident) == 0;
}

}  // namespace

TEST_CASE("a block is zeros from a multiple of a large page on, of any size") {
  for (const std::size_t bytes :
       {std::size_t{0}, std::size_t{1}, std::size_t{5000}, kPiece, 3 * kPiece + 7}) {
    const LargeBlock block(bytes);
    CHECK(block.size() == bytes);
    CHECK(reinterpret_cast<std::uintptr_t>(block.data()) % kPiece == 0);
    CHECK(std::count(block.data(), block.data() + bytes, '\0') == static_cast<std::ptrdiff_t>(bytes));
  }
}

TEST_CASE("a block takes the small pages that it needs, and a whole large one for more than half of it") {
  constexpr std::size_t kPage = 4096;
  const std::pair<std::size_t, std::size_t> taken[] = {{1, kPage},
                                                       {5000, 2 * kPage},
                                                       {kPiece, kPiece},
                                                       {kPiece + 1, kPiece + kPage},
                                                       {3 * kPiece / 2, 3 * kPiece / 2},
                                                       {3 * kPiece / 2 + 1, 2 * kPiece},
                                                       {kPiece - 1, kPiece}};
  for (const auto& [bytes, mapped] : taken) {
    const std::size_t size = bytes;  // a binding cannot be captured
    CAPTURE(size);
    const LargeBlock block(bytes);
    char* const first = const_cast<char*>(block.data());
    CHECK(is_there(first + mapped - kPage));
    CHECK_FALSE(is_there(first + mapped));  // what is behind it was given back
  }
}

TEST_CASE("pieces that somebody uses outlive the block, the others go with it") {
  std::optional<LargeBlock> block(4 * kPiece);
  char* const first = block->data();
  first[2 * kPiece - 1] = 'a', first[2 * kPiece] = 'b';
  std::shared_ptr<char> across = block->part(2 * kPiece - 1, 2), within = block->part(3 * kPiece, kPiece);
  block.reset();
  CHECK_FALSE(is_there(first));
  REQUIRE(is_there(first + kPiece));
  REQUIRE(is_there(first + 2 * kPiece));
  CHECK(across.get()[0] == 'a');
  CHECK(across.get()[1] == 'b');
  across.reset();
  CHECK_FALSE(is_there(first + kPiece));
  CHECK_FALSE(is_there(first + 2 * kPiece));
  CHECK(is_there(within.get()));
}

TEST_CASE("a file that was read stays as it was, whoever cuts it off or writes over it") {
  const test::TemporaryFolder folder;
  std::string text(kPiece + 12345, 'a');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>('a' + i / 5000 % 26);
  const std::filesystem::path file = folder.write("a", text);
  const LargeBlock block = read_block(file);
  std::ofstream(file, std::ios::trunc) << "b";
  CHECK(std::string_view(block.data(), block.size()) == text);
  CHECK(read_block(folder.write("empty", "")).size() == 0);
  CHECK_THROWS_AS(read_block(folder.path / "nothing"), InputError);
  CHECK_THROWS_WITH_AS(read_block(folder.path), doctest::Contains("no regular file"), InputError);
}
