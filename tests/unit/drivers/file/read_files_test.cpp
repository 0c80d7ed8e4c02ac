// What a program reads is never written over, by whatever name it goes.
#include "rigsound/file/read_files.hpp"

#include <doctest/doctest.h>

#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
namespace fs = std::filesystem;

TEST_CASE("an input is refused as output by its name, through links and inside a folder that is read") {
  const test::TemporaryFolder folder;
  const fs::path recording = folder.write("in.wav", "x"),
                 clicks = folder.write("set/banks/a/clicks.wav", "x");
  const fs::path set = folder.path / "set";
  fs::create_symlink(recording, folder.path / "soft.wav");
  fs::create_hard_link(recording, folder.path / "hard.wav");
  fs::create_directory_symlink(set, folder.path / "other_set");
  const std::vector<fs::path> inputs = {recording, set, "", folder.path / "not_there.csv"};
  for (const fs::path& output :
       {recording, folder.path / "soft.wav", folder.path / "hard.wav", folder.path / "set/../in.wav", clicks,
        folder.path / "other_set/banks/a/clicks.wav", folder.path / "not_there.csv", set})
    CHECK_THROWS_AS_MESSAGE(require_not_read(output, inputs), InputError, output.string());
  for (const fs::path& output : {folder.path / "out.wav", set / "banks/a/new.wav", fs::path()})
    CHECK_NOTHROW(require_not_read(output, inputs));
}
