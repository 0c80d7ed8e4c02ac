// The status as OSC: which address carries which figure, and how many go together.
#include "osc_output.hpp"

#include <doctest/doctest.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "daemon/running_daemon.hpp"
#include "daemon/telling_snapshot.hpp"
#include "rigsound/osc/packet.hpp"
#include "rigsound/socket/tcp_listener.hpp"
#include "rigsound/udp/udp_sender.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

using OscSaid = std::variant<int, float, std::string>;

std::map<std::string, OscSaid> told_by_osc(const Snapshot& snapshot) {
  std::map<std::string, OscSaid> told;
  for (const std::vector<osc::Value>& bundle : osc_bundles(snapshot))
    for (const osc::Value& value : bundle) {
      CHECK(told.count(value.path) == 0);
      told[value.path] = value.value;
    }
  return told;
}

}  // namespace

TEST_CASE("OSC carries mute, pause and meters, each at its address and of its type") {
  auto told = told_by_osc(test::telling_snapshot());
  CHECK(told["/rigsound/muted"] == OscSaid(1));
  CHECK(told["/rigsound/paused"] == OscSaid(0));
  CHECK(told["/rigsound/meters/output_gain"] == OscSaid(0.875F));
  CHECK(told["/rigsound/meters/lost_clicks"] == OscSaid(23.0F));
  CHECK(told["/rigsound/meters/dropped_chunks"] == OscSaid(24.0F));
  CHECK(std::get<float>(told["/rigsound/meters/peak_db"]) == doctest::Approx(-6.0206));
  CHECK(std::get<float>(told["/rigsound/meters/diesel/rms_db"]) == doctest::Approx(-24.0824));
  CHECK(told.count("/rigsound/version") == 0);
}

TEST_CASE("OSC carries a signal that a bus or a user has said, and none that nobody has") {
  auto told = told_by_osc(test::telling_snapshot());
  CHECK(told["/rigsound/engine_rpm"] == OscSaid(1500.0F));
  CHECK(told["/rigsound/rock"] == OscSaid(1.0F));  // by hand
  CHECK(told.count("/rigsound/rod_count") == 0);
}

TEST_CASE("OSC carries of a boom its situation, impacts, levels and controls") {
  auto told = told_by_osc(test::telling_snapshot());
  CHECK(told["/rigsound/left/situation"] == OscSaid("open_rattling"));
  CHECK(told["/rigsound/left/hammering"] == OscSaid(1));
  CHECK(told["/rigsound/left/feed_deviation"] == OscSaid(-1.5F));
  CHECK(told["/rigsound/left/rods"] == OscSaid(3.0F));
  CHECK(told["/rigsound/left/rock"] == OscSaid("slate"));
  CHECK(told["/rigsound/left/impacts_made_hz"] == OscSaid(39.0F));
  CHECK(std::get<float>(told["/rigsound/left/levels/string/peak_db"]) == doctest::Approx(-42.1442));
  for (const ControlInfo& control : control_table())
    CHECK(told["/rigsound/left/" + std::string(control.name)] ==
          OscSaid(static_cast<float>(control.neutral)));
  CHECK(told.count("/rigsound/left/name") == 0);
  CHECK(told.count("/rigsound/left/banks") == 0);  // a list
}

TEST_CASE("Full bundles hold 40 values, the last one the rest, and no value is lost") {
  Snapshot s = test::telling_snapshot();
  const std::size_t of_one = told_by_osc(s).size();
  s.booms.resize(4, s.booms[0]);
  for (std::size_t b = 1; b < s.booms.size(); ++b) s.booms[b].name = "boom" + std::to_string(b);
  const auto bundles = osc_bundles(s);
  std::size_t values = 0;
  for (std::size_t i = 0; i < bundles.size(); ++i) {
    CHECK((i + 1 < bundles.size() ? bundles[i].size() == 40 : bundles[i].size() <= 40));
    CHECK_FALSE(bundles[i].empty());
    values += bundles[i].size();
  }
  CHECK(bundles.size() > 1);
  std::size_t of_boom = 0;
  for (const auto& [path, said] : told_by_osc(test::telling_snapshot()))
    if (path.rfind("/rigsound/left/", 0) == 0) ++of_boom;
  CHECK(values == of_one + 3 * of_boom);
}

TEST_CASE("OSC goes out when it is due, and never without a target") {
  CHECK_FALSE(OscOutput().due(1e9));
  osc::OscOptions options;
  options.targets = {"127.0.0.1:9"};
  options.every_s = 0.5;
  OscOutput output(options);
  CHECK(output.due(100));
  output.send(test::telling_snapshot(), 100);
  CHECK_FALSE(output.due(100.25));
  CHECK(output.due(100.5));
}

TEST_CASE("A daemon tells its OSC targets the status, and takes mute and controls by OSC") {
  const FileDescriptor tablet = listen_udp({"127.0.0.1", 0});
  const std::string in = "127.0.0.1:" + std::to_string(bound_port(listen_udp({"127.0.0.1", 0})));
  const test::SmallRig rig;
  rig.write_rig("[osc]\naddress = \"" + in +
                "\"\ntargets = [\"127.0.0.1:" + std::to_string(bound_port(tablet)) + "\"]\n");
  Daemon daemon({(rig.folder.path / "rig.toml").string(), {}});
  const test::Running running(daemon);
  const auto muted_as_told = [&] {
    for (;;) {
      pollfd poll{tablet.get(), POLLIN, 0};
      REQUIRE(::poll(&poll, 1, 60000) == 1);
      std::array<char, 65536> bytes{};
      const ssize_t got = ::recv(tablet.get(), bytes.data(), bytes.size(), 0);
      std::string problem;
      const auto packet =
          osc::read_packet(std::string_view(bytes.data(), static_cast<std::size_t>(got)), problem);
      REQUIRE(packet);
      for (const osc::Message& message : *packet)
        if (message.path == "/rigsound/muted") return std::get<double>(message.said);
    }
  };
  CHECK(muted_as_told() == 0);
  const udp::UdpSender mixer(in);
  const nlohmann::json muted = test::status_when(rig.socket(), [&](const nlohmann::json& s) {
    mixer.send(osc::write_bundle({{"/rigsound/mute", 1}, {"/rigsound/decay_factor", 2.0F}}));
    return s["muted"] == true && s["booms"][0]["decay_factor"] == 2;
  });
  CHECK(muted["muted"] == true);
  CHECK(muted["booms"][0]["decay_factor"] == 2);
  bool told = false;
  for (int i = 0; i < 1000 && !told; ++i) told = muted_as_told() == 1;
  CHECK(told);
}
