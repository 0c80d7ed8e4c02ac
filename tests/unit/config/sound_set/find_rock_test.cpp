// A rock by its name: of the set, else of the usual ones.
#include <doctest/doctest.h>

#include "rigsound/config/sound_set_index.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

std::string said_of_rock(const std::filesystem::path& set, const std::string& name) {
  return test::complaint([&] { config::find_rock(set, name); });
}

}  // namespace

TEST_CASE("a rock of the usual ones is there without a set") {
  for (const config::RockEntry& rock : config::kUsualRocks) {
    CHECK(config::find_rock({}, rock.name).name == rock.name);
    CHECK(config::find_rock({}, rock.name).stiffness == rock.stiffness);
  }
  CHECK(said_of_rock({}, "harder").rfind("--rock: is \"harder\", expected medium, soft, hard", 0) == 0);
  CHECK(said_of_rock({}, "harder").find("; did you mean hard?") != std::string::npos);
  CHECK(said_of_rock({}, "something quite else").find("did you mean") == std::string::npos);
}

TEST_CASE("a rock that the set names is the set's") {
  const test::TemporaryFolder set;
  config::SoundSetIndex index;
  index.rocks = {{"gabbro", 7e8}, {"soft", 6e7}};
  config::merge_index(set.path, index);
  CHECK(config::find_rock(set.path, "gabbro").stiffness == 7e8);
  CHECK(config::find_rock(set.path, "soft").stiffness == 6e7);
  CHECK(config::find_rock(set.path, "hard").stiffness == 5e8);
  CHECK(said_of_rock(set.path, "gabro") ==
        (set.path / "soundset.toml").string() +
            ": rock: is \"gabro\", expected gabbro, soft, medium, soft, hard, hardest; did you mean gabbro?");
}
