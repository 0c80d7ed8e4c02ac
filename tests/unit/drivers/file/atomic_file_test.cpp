#include "rigsound/file/atomic_file.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "rigsound/device_error.hpp"

using namespace rigsound;
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

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a committed file holds the text and leaves no temporary") {
  Folder folder;
  write_file(folder.path / "a.txt", "one");
  write_file(folder.path / "a.txt", "two");
  CHECK(content(folder.path / "a.txt") == "two");
  CHECK(folder.files() == 1);
}

TEST_CASE("only a regular file is replaced: no device, no folder") {
  Folder folder;
  fs::create_directories(folder.path / "inside");
  REQUIRE(::mkfifo((folder.path / "pipe").c_str(), 0600) == 0);
  for (const char* name : {"inside", "pipe"})
    CHECK_THROWS_WITH_AS(write_file(folder.path / name, "x"), doctest::Contains("no regular file"),
                         DeviceError);
  CHECK(fs::is_fifo(folder.path / "pipe"));
  CHECK(folder.files() == 2);
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
