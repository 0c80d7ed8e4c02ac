// Names under which a UDP input takes signals: the first boom's have a second one, with the boom before it.
#include <doctest/doctest.h>

#include "config/rig/rig_texts.hpp"

using namespace rigsound;
using namespace rigsound::test;

TEST_CASE("signals of the first boom have an alias, those of the rig and of other booms have none") {
  const config::Rig rig = loaded("[[boom]]\nname = \"a\"\n[[boom]]\nname = \"b\"\n[[udp]]\n");
  const auto alias = [&](const std::string& name) -> std::string {
    for (const udp::NameRoute& route : rig.udp.at(0).routes)
      if (route.name == name) return route.alias.empty() ? "none" : route.alias;
    return "no such route";
  };
  CHECK(alias("rattling") == "a.rattling");
  CHECK(alias("b.rattling") == "none");
  CHECK(alias("engine_rpm") == "none");
  CHECK(alias("a.rattling") == "no such route");
}
