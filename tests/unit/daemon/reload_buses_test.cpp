// What a reload does to the buses: those told the same go on, the others end and begin.
#include <doctest/doctest.h>

#include <string>

#include "daemon/running_daemon.hpp"
#include "rigsound/socket/tcp_listener.hpp"
#include "rigsound/udp/udp_sender.hpp"

using namespace rigsound;
using namespace rigsound::test;

namespace {

/// HOST:PORT that nobody listens at.
std::string free_udp_address() {
  return "127.0.0.1:" + std::to_string(bound_port(listen_udp({"127.0.0.1", 0})));
}

std::string udp_bus(const std::string& address, const char* signal) {
  return "[[udp]]\naddress = \"" + address + "\"\nsignals = [\"" + signal + "\"]\n";
}

}  // namespace

TEST_CASE("A bus told the same goes on over a reload, one told otherwise begins anew, one left out ends") {
  const SmallRig rig;
  const std::string a = free_udp_address(), b = free_udp_address();
  rig.write_rig(udp_bus(a, "engine_rpm") + udp_bus(b, "rod_count"));
  daemon::Daemon daemon({(rig.folder.path / "rig.toml").string(), {}});
  const Running running(daemon);
  const auto frames = [](const nlohmann::json& s, int bus) { return s["buses"][bus]["frames_seen"]; };
  const auto reload = [&] {
    CHECK(ask(rig.socket(), {{"command", "reload"}})["ok"] == true);
    return status(rig.socket());
  };
  const udp::UdpSender to_a(a), to_b(b);
  const nlohmann::json heard = status_when(rig.socket(), [&](const nlohmann::json& s) {
    if (frames(s, 0) == 0) to_a.send(R"({"engine_rpm": 900})");
    if (frames(s, 1) == 0) to_b.send(R"({"rod_count": 3})");
    return s["buses"][0]["frames_used"] == 1 && s["buses"][1]["frames_used"] == 1;
  });
  REQUIRE(heard["buses"].size() == 2);
  REQUIRE(frames(heard, 0) == 1);
  REQUIRE(frames(heard, 1) == 1);

  const nlohmann::json same = reload();
  CHECK(frames(same, 0) == 1);
  CHECK(frames(same, 1) == 1);

  rig.write_rig(udp_bus(a, "engine_rpm") + udp_bus(b, "rock"));
  const nlohmann::json other = reload();
  REQUIRE(other["buses"].size() == 2);
  CHECK(other["buses"][0]["name"] == heard["buses"][0]["name"]);
  CHECK(frames(other, 0) == 1);
  CHECK(frames(other, 1) == 0);

  rig.write_rig(udp_bus(a, "engine_rpm"));
  const nlohmann::json one = reload();
  REQUIRE(one["buses"].size() == 1);
  CHECK(frames(one, 0) == 1);
  CHECK(one["reloads"] == 3);
}
