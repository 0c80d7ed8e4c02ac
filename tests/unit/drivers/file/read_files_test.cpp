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
  fs::create_hard_link(clicks, folder.path / "hard_clicks.wav");
  fs::create_directory_symlink(set, folder.path / "other_set");
  const std::vector<fs::path> inputs = {recording, set, "", folder.path / "not_there.csv"};
  for (const fs::path& output :
       {recording, folder.path / "soft.wav", folder.path / "hard.wav", folder.path / "set/../in.wav", clicks,
        folder.path / "other_set/banks/a/clicks.wav", folder.path / "not_there.csv",
        folder.path / "hard_clicks.wav", set})
    CHECK_THROWS_AS_MESSAGE(require_apart({output}, inputs), InputError, output.string());
  for (const fs::path& output : {folder.path / "out.wav", set / "banks/a/new.wav", fs::path()})
    CHECK_NOTHROW(require_apart({output}, inputs));
}

TEST_CASE("two outputs have two names, and what comes through a pipe is no file") {
  const test::TemporaryFolder folder;
  const fs::path a = folder.path / "a.wav", b = folder.write("b.wav", "x"), link = folder.path / "link.wav";
  fs::create_symlink(b, link);
  CHECK_NOTHROW(require_apart({a, b, ""}, {}));
  CHECK_THROWS_AS(require_apart({a, b, a}, {}), InputError);
  CHECK_THROWS_AS(require_apart({link, b}, {}), InputError);
  CHECK_NOTHROW(require_apart({"-", "/dev/null", "/dev/null"}, {"-", "/dev/null"}));
}

TEST_CASE("an input may not lie in a folder that is made anew") {
  const test::TemporaryFolder folder;
  const fs::path start = folder.write("set/backgrounds/diesel/start.wav", "x");
  fs::create_directory_symlink(folder.path / "set", folder.path / "other");
  CHECK_THROWS_AS(require_outside(folder.path / "set/backgrounds/diesel", {"", start}), InputError);
  CHECK_THROWS_AS(require_outside(folder.path / "other/backgrounds/diesel", {start}), InputError);
  CHECK_NOTHROW(require_outside(folder.path / "set/backgrounds/other", {start}));
}
