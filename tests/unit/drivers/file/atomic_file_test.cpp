#include "rigsound/file/atomic_file.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "rigsound/device_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using test::content;
namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / "rigsound_atomic_file_test";
  Folder() { fs::remove_all(path), fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  int files() const {
    return static_cast<int>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

}  // namespace

TEST_CASE("a committed file holds the text and leaves no temporary") {
  Folder folder;
  write_file(folder.path / "a.txt", "one");
  write_file(folder.path / "a.txt", "two");
  CHECK(content(folder.path / "a.txt") == "two");
  CHECK(folder.files() == 1);
}

TEST_CASE("a folder is not replaced, a device stays one") {
  Folder folder;
  fs::create_directories(folder.path / "inside");
  CHECK_THROWS_WITH_AS(write_file(folder.path / "inside", "x"), doctest::Contains("is a folder"),
                       DeviceError);
  write_file("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
  CHECK_THROWS_WITH_AS(write_file("/dev/full", "x"), doctest::Contains("No space left"), DeviceError);
  CHECK(folder.files() == 1);
}

TEST_CASE("a pipe gets the whole content, of a file that could be written in any order") {
  Folder folder;
  const fs::path pipe = folder.path / "pipe.wav";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::string got;
  std::thread reader([&] { got = content(pipe); });
  const std::string text(300000, 'x');
  write_file(pipe, text);
  reader.join();
  CHECK(got == text);
  CHECK(fs::is_fifo(pipe));
  CHECK(folder.files() == 1);
}

TEST_CASE("a link stays, and what it leads to is replaced") {
  Folder folder;
  fs::create_directories(folder.path / "other");
  write_file(folder.path / "other/a.txt", "old");
  fs::create_symlink("other/a.txt", folder.path / "link.txt");
  fs::create_symlink("other/new.txt", folder.path / "dangling.txt");
  write_file(folder.path / "link.txt", "new");
  write_file(folder.path / "dangling.txt", "made");
  CHECK(fs::is_symlink(folder.path / "link.txt"));
  CHECK(content(folder.path / "other/a.txt") == "new");
  CHECK(content(folder.path / "other/new.txt") == "made");
}

TEST_CASE("a file that was not committed leaves the old one as it was") {
  Folder folder;
  write_file(folder.path / "a.wav", "old");
  {
    AtomicFile file(folder.path / "a.wav");
    CHECK(file.temporary().extension() == ".wav");
    std::ofstream(file.temporary()) << "half";
  }
  CHECK(content(folder.path / "a.wav") == "old");
  CHECK(folder.files() == 1);
}

TEST_CASE("a folder that is not there is a device error") {
  CHECK_THROWS_AS(write_file("/nonexistent/folder/a.txt", "x"), DeviceError);
}
