// What is opened for reading: files and pipes to their end, and why others are refused.
#include "rigsound/file/input_file.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "rigsound/file/file_descriptor.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

struct InputPipe {
  InputPipe() {
    int ends[2] = {-1, -1};
    REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
    out = FileDescriptor(ends[0]), in = FileDescriptor(ends[1]);
  }
  std::string path() const { return "/proc/self/fd/" + std::to_string(out.get()); }

  FileDescriptor out, in;
};

/// A pipe that holds these bytes and no more will come.
InputPipe pipe_of(const std::string& bytes) {
  InputPipe pipe;
  REQUIRE(::write(pipe.in.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  pipe.in = FileDescriptor();
  return pipe;
}

/// What is said of an input behind its name, nothing when it is taken.
std::string input_refusal(const std::string& file, std::uintmax_t most_bytes = 1000) {
  const std::string said = test::complaint([&] { InputFile(file, "log", most_bytes); });
  const std::size_t name = (file == "-" ? "standard input" : file).size();
  return said.empty() ? said : said.substr(name + 2);
}

}  // namespace

TEST_CASE("a file is read where it lies, a pipe to its end, each as long as it may be") {
  const std::string bytes(1000, 'x');
  const test::TemporaryFolder folder;
  const std::string file = folder.write("a", bytes).string();
  CHECK(InputFile(file, "log", 1000).content() == bytes);
  CHECK(InputFile(file, "log").path() == file);
  CHECK(input_refusal(file, 999) == "is of 1 MiB, expected a log of at most 1 MiB");
  CHECK(InputFile(pipe_of(bytes).path(), "log", 1000).content() == bytes);
  CHECK(InputFile(pipe_of("").path(), "log").content().empty());
  CHECK(input_refusal(pipe_of(bytes).path(), 999) == "has more than 1 MiB, expected no more");
}

TEST_CASE("a folder, a file that is not there and a standard input that cannot be read are refused") {
  const test::TemporaryFolder folder;
  CHECK(input_refusal(folder.path.string()) == "is a folder, expected a log");
  CHECK(input_refusal((folder.path / "none").string()) == "cannot be opened, expected a readable log");
  const InputPipe pipe;
  const FileDescriptor before(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3));
  REQUIRE(::dup2(pipe.in.get(), STDIN_FILENO) == STDIN_FILENO);  // for writing only
  const std::string said = input_refusal("-");
  REQUIRE(::dup2(before.get(), STDIN_FILENO) == STDIN_FILENO);
  CHECK(said == "cannot be read: Bad file descriptor");
}
