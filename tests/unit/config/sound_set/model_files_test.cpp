// Tools, strings and backgrounds in files: what is there already is never lost.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/config/background_files.hpp"
#include "rigsound/config/tool_files.hpp"
#include "rigsound/default_diesel.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

namespace {

ToolModel tool_of(double length_m) {
  ToolModel tool;
  tool.name = "hex25";
  tool.bar.length_m = length_m;
  return tool;
}

}  // namespace

TEST_CASE("a tool that is saved over another puts that aside, under the first free name") {
  const TemporaryFolder set;
  const fs::path file = set.path / "tools/hex25.json";
  CHECK(config::save_tool(set.path, tool_of(0.5)).empty());
  CHECK(config::save_tool(set.path, tool_of(0.5)).empty());  // the same
  std::vector<fs::path> kept;
  for (const double length_m : {0.6, 0.7, 0.8})
    kept.push_back(config::save_tool(set.path, tool_of(length_m)));
  CHECK(kept ==
        std::vector<fs::path>{file.string() + ".old", file.string() + ".old2", file.string() + ".old3"});
  CHECK(config::load_tool(file).bar.length_m == 0.8);
  CHECK(config::load_tool(file).name == "hex25");
  fs::remove(kept[1]);
  CHECK(config::save_tool(set.path, tool_of(0.9)) == kept[1]);
  CHECK_FALSE(complaint([&] {
                ToolModel outside;
                outside.name = "../hex25";
                config::save_tool(set.path, outside);
              }).empty());
}

TEST_CASE("a tool is brought back from what was kept last, and again, and not at all where nothing was") {
  const TemporaryFolder set;
  const fs::path file = set.path / "tools/hex25.json";
  const auto length_m = [&] { return config::load_tool(file).bar.length_m; };
  config::save_tool(set.path, tool_of(0.5));
  CHECK_FALSE(config::restore_tool(set.path, "hex25"));
  CHECK(length_m() == 0.5);
  config::save_tool(set.path, tool_of(0.6));
  config::save_tool(set.path, tool_of(0.7));
  CHECK(config::restore_tool(set.path, "hex25"));
  CHECK(length_m() == 0.6);
  CHECK(config::restore_tool(set.path, "hex25"));
  CHECK(length_m() == 0.7);
}

TEST_CASE("a background's grains lie in files numbered from 1, of one cycle and a quarter each") {
  const TemporaryFolder set;
  DieselModel diesel = default_diesel();
  diesel.name = "diesel";
  REQUIRE(diesel.points.size() > 1);
  const auto samples = static_cast<std::size_t>(diesel.angle_samples * 1.25);
  for (std::size_t i = 0; i < diesel.points.size(); ++i)
    diesel.points[i].grains.assign(i == 1 ? 0 : 2, std::vector<float>(samples, 0.125F));
  config::save_background(set.path, diesel);
  const fs::path folder = set.path / "backgrounds/diesel";
  CHECK(fs::exists(folder / "grains_1.wav"));
  CHECK_FALSE(fs::exists(folder / "grains_0.wav"));
  CHECK_FALSE(fs::exists(folder / "grains_2.wav"));
  const DieselModel again = config::load_background(folder);
  REQUIRE(again.points.size() == diesel.points.size());
  for (std::size_t i = 0; i < diesel.points.size(); ++i)
    CHECK(again.points[i].grains == diesel.points[i].grains);
}
