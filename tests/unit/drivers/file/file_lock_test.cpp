#include "rigsound/file/file_lock.hpp"

#include <doctest/doctest.h>

#include "temporary_folder.hpp"

using namespace rigsound;
using rigsound::test::TemporaryFolder;

TEST_CASE("a lock keeps others out, and its file goes with it") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "lock";
  {
    FileLock held(file), refused(file);
    CHECK(held.try_exclusive());
    CHECK_FALSE(refused.try_exclusive());
  }
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("who had opened a file that its holder removed locks the one that is there now") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "lock";
  FileLock late(file);
  {
    FileLock first(file);
    REQUIRE(first.try_exclusive());
  }
  REQUIRE_FALSE(std::filesystem::exists(file));
  {
    FileLock now(file);
    REQUIRE(now.try_exclusive());
    CHECK_FALSE(late.try_exclusive());
  }
  CHECK(late.try_exclusive());
  CHECK(std::filesystem::exists(file));
}
