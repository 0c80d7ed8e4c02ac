#include "rigsound/file/atomic_folder.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <iterator>
#include <string>
#include <thread>

#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/make_folders.hpp"
#include "rigsound/file/unfinished.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using test::content;
namespace fs = std::filesystem;

namespace {

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

}  // namespace

TEST_CASE("a folder that joins another leaves what else is in it") {
  const test::TemporaryFolder at;
  at.write("out/kept.txt", "kept");
  at.write("out/inside/both.txt", "old");
  {
    AtomicFolder folder(at.path / "out");
    at.write((folder.temporary() / "inside/both.txt").string(), "new");
    at.write((folder.temporary() / "more/one.txt").string(), "one");
    CHECK(content(at.path / "out/inside/both.txt") == "old");
    folder.join();
  }
  CHECK(content(at.path / "out/kept.txt") == "kept");
  CHECK(content(at.path / "out/inside/both.txt") == "new");
  CHECK(content(at.path / "out/more/one.txt") == "one");
  CHECK(entries(at.path) == 1);
}

TEST_CASE("a folder that was neither put in place nor joined leaves nothing") {
  const test::TemporaryFolder at;
  for (const bool joins : {false, true}) {
    AtomicFolder folder(at.path / "out");
    at.write((folder.temporary() / "a.txt").string(), "a");
    if (joins) folder.join();
  }
  CHECK(content(at.path / "out/a.txt") == "a");
  CHECK(entries(at.path) == 1);
}

TEST_CASE("what is unfinished when a program is ended is undone, what is finished stays") {
  const test::TemporaryFolder at;
  at.write("old.txt", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    write_file(at.path / "done.txt", "done");
    const AtomicFile file(at.path / "old.txt"), other(at.path / "new.txt");
    const AtomicFolder folder(at.path / "folder");
    at.write((folder.temporary() / "inside/a.txt").string(), "a");
    const bool there = entries(at.path) == 5;
    undo_unfinished();
    ::_exit(there ? 0 : 1);
  }
  int status = -1;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  CHECK(content(at.path / "old.txt") == "old");
  CHECK(content(at.path / "done.txt") == "done");
  CHECK(entries(at.path) == 2);
}

TEST_CASE("folders are made with their parents, and none of them again once a signal has removed them") {
  const test::TemporaryFolder at;
  make_folders(at.path / "a/b");
  make_folders(at.path / "a/b");
  CHECK(fs::is_directory(at.path / "a/b"));
  at.write("file", "");
  CHECK_THROWS_AS(make_folders(at.path / "file/in"), DeviceError);
  const pid_t child = ::fork();
  if (child == 0) {
    const AtomicFolder folder(at.path / "folder");
    const fs::path inside = folder.temporary() / "segment";
    undo_unfinished();
    std::thread([&] { make_folders(inside); }).detach();
    std::thread([&] { AtomicFolder(inside / "bank"); }).detach();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::_exit(0);
  }
  int status = -1;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  CHECK(entries(at.path) == 2);
}
