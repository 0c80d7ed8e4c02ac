// A real server on loopback, a real libmodbus client, and callers that mean no good.
#include "modbus/tcp_server.hpp"

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

#include "drivers/modbus/bus_harness.hpp"
#include "rigsound/socket/network.hpp"
#include "rigsound/socket/tcp_connector.hpp"

using namespace rigsound;
using namespace rigsound::modbus;

namespace {

struct Served {
  explicit Served(double master_gone_after_s = 1) {
    options.master_gone_after_s = master_gone_after_s;
    options.host = "127.0.0.1";
    options.port = 0;
    options.routes = {
        route(Signal::kFeedPressureBar, Table::kHolding, 0, WordType::kUint16, WordOrder::kAbcd, 0.1),
        route(Signal::kEngineRpm, Table::kHolding, 2, WordType::kFloat32),
        route(Signal::kPercussion, Table::kCoil, 0), route(Signal::kRodCount, Table::kHolding, 4)};
    server = std::make_unique<TcpServer>(options, told, &told);
    server->step();  // starts to listen
    REQUIRE(server->port() != 0);
    running = std::make_unique<Running>(*server);
  }

  Context client() {
    Context c(modbus_new_tcp("127.0.0.1", server->port()));
    modbus_set_slave(c.get(), 1);
    modbus_set_response_timeout(c.get(), 30, 0);
    REQUIRE(modbus_connect(c.get()) == 0);
    return c;
  }

  /// Connected from 127.0.0.`last`.
  FileDescriptor raw(int last = 1) {
    FileDescriptor fd(::socket(AF_INET, SOCK_STREAM, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK - 1 + static_cast<unsigned>(last));
    REQUIRE(::bind(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    address.sin_port = htons(static_cast<std::uint16_t>(server->port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::connect(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    return fd;
  }

  ModbusOptions options;
  Told told;
  std::unique_ptr<TcpServer> server;
  std::unique_ptr<Running> running;
};

void send_all(const FileDescriptor& fd, const std::vector<std::uint8_t>& bytes) {
  REQUIRE(::send(fd.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size()));
}

bool closed_by_peer(const FileDescriptor& fd) {
  std::uint8_t byte = 0;
  return ::recv(fd.get(), &byte, 1, 0) <= 0;
}

}  // namespace

TEST_CASE("Every writing function changes state, every reading one shows it") {
  Served s;
  const Context c = s.client();
  REQUIRE(modbus_write_register(c.get(), 0, 855) == 1);
  await([&] { return s.told.of(Signal::kFeedPressureBar).value == doctest::Approx(85.5); });
  const std::vector<Exchange> recorded = s.told.exchanges();
  REQUIRE(recorded.size() == 1);
  CHECK(recorded[0].written);
  CHECK(recorded[0].table == Table::kHolding);
  CHECK(recorded[0].address == 0);
  CHECK(recorded[0].values == std::vector<std::uint16_t>{855});
  const std::uint16_t rpm[] = {0x43F9, 0xB000};
  REQUIRE(modbus_write_registers(c.get(), 2, 2, rpm) == 2);
  await([&] { return s.told.of(Signal::kEngineRpm).value == 499.375; });
  REQUIRE(modbus_write_bit(c.get(), 0, 1) == 1);
  await([&] { return s.told.of(Signal::kPercussion).value == 1; });
  const std::uint8_t off = 0;
  REQUIRE(modbus_write_bits(c.get(), 0, 1, &off) == 1);
  await([&] { return s.told.of(Signal::kPercussion).value == 0; });
  const std::uint16_t rods = 5;
  std::uint16_t got[5] = {};
  REQUIRE(modbus_write_and_read_registers(c.get(), 4, 1, &rods, 0, 5, got) == 5);
  await([&] { return s.told.of(Signal::kRodCount).value == 5; });
  CHECK(got[0] == 855);
  CHECK(got[4] == 5);
  REQUIRE(modbus_mask_write_register(c.get(), 4, 0xfffc, 0x0002) == 1);  // 5 & ~3 | 2 = 6
  await([&] { return s.told.of(Signal::kRodCount).value == 6; });
  REQUIRE(modbus_read_registers(c.get(), 0, 5, got) == 5);
  CHECK(got[2] == 0x43F9);
  CHECK(got[4] == 6);
  await([&] { return count(*s.server, "frames_used") == 7; });
  CHECK(count(*s.server, "requests_refused") == 0);
}

TEST_CASE("Values that are no values and addresses that are none are refused, the old value stays") {
  Served s;
  const Context c = s.client();
  REQUIRE(modbus_write_register(c.get(), 0, 855) == 1);
  const std::size_t before = s.told.total();
  const std::uint16_t nan[] = {0x7fc0, 0}, infinity[] = {0x7f80, 0};
  const auto refused_as = [](int code, int result) { return result == -1 && errno == MODBUS_ENOBASE + code; };
  CHECK(refused_as(3, modbus_write_registers(c.get(), 2, 2, nan)));
  CHECK(refused_as(3, modbus_write_registers(c.get(), 2, 2, infinity)));
  CHECK(refused_as(3, modbus_write_register(c.get(), 0, 3001)));
  CHECK(refused_as(3, modbus_write_register(c.get(), 2, 0x43F9)));
  CHECK(refused_as(2, modbus_write_register(c.get(), 1, 0)));
  const std::uint16_t half[] = {1, 0x43F9};
  CHECK(refused_as(3, modbus_write_registers(c.get(), 1, 2, half)));
  CHECK(refused_as(2, modbus_write_register(c.get(), 999, 0)));
  std::uint16_t got[6] = {};
  CHECK(refused_as(2, modbus_read_registers(c.get(), 0, 6, got)));
  CHECK(refused_as(2, modbus_read_input_registers(c.get(), 0, 1, got)));
  std::uint8_t id[64] = {};
  CHECK(refused_as(1, modbus_report_slave_id(c.get(), 64, id)));
  CHECK(s.told.total() == before);
  await([&] { return count(*s.server, "requests_refused") == 10; });
  CHECK(s.told.notices() == 3);  // one a kind: value, address, function
  REQUIRE(modbus_read_registers(c.get(), 0, 1, got) == 1);
  CHECK(got[0] == 855);
}

TEST_CASE("A write over addresses that nobody uses takes those that are") {
  Served s;
  const Context c = s.client();
  const std::uint16_t all[] = {7, 855, 9, 0x43F9, 0xB000, 5, 11, 12};
  REQUIRE(modbus_write_registers(c.get(), 0, 5, all + 1) == 5);
  await([&] { return s.told.of(Signal::kRodCount).value == 5; });
  CHECK(s.told.of(Signal::kEngineRpm).value == 499.375);
  CHECK(s.told.of(Signal::kFeedPressureBar).value == doctest::Approx(85.5));
  REQUIRE(modbus_write_registers(c.get(), 4, 3, all + 5) == 3);  // beyond the last one
  CHECK(modbus_write_registers(c.get(), 5, 2, all) == -1);       // none of them
}

TEST_CASE("0 stands for the bank's own rate, over Modbus too") {
  Told told;
  ModbusOptions options;
  options.port = 0;
  options.routes = {route(Signal::kPercussionRateHz, Table::kHolding, 0)};
  RegisterFile registers(options.routes);
  Request request;
  request.write = modbus::Range{0, 1};
  request.values = {0};
  Exchange change;
  CHECK_FALSE(registers.check(request, change));
  request.values = {3};
  CHECK(registers.check(request, change) == Refusal::kValue);
}

TEST_CASE("A manual's number that was sent as an address gets a hint") {
  Served s;
  const Context c = s.client();
  CHECK(modbus_write_register(c.get(), 40001, 5) == -1);
  await([&] { return s.told.notices() == 1; });
  CHECK(s.told.last_text() ==
        "127.0.0.1: function 6 refused: address not in the rig, holding 40001 = 80002: addresses count from "
        "0, did "
        "you mean holding 0 = 40001?");
}

TEST_CASE("When the last connection that wrote is gone, and stays away, its signals are down") {
  Served s;
  const auto down = [&] { return s.told.of(Signal::kFeedPressureBar).validity == Validity::kBusDown; };
  auto first = s.client(), second = s.client(), reader = s.client();
  REQUIRE(modbus_write_register(first.get(), 0, 855) == 1);
  REQUIRE(modbus_write_register(second.get(), 4, 5) == 1);
  std::uint16_t got = 0;
  REQUIRE(modbus_read_registers(reader.get(), 0, 1, &got) == 1);
  first.reset();
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  CHECK_FALSE(down());  // the second is a master too
  second.reset();
  await(down);
  CHECK(s.told.of(Signal::kRodCount).validity == Validity::kBusDown);
  CHECK(s.told.downs() == 0);  // the server itself is up
  const auto again = s.client();
  REQUIRE(modbus_write_register(again.get(), 0, 700) == 1);
  await([&] { return s.told.of(Signal::kFeedPressureBar).value == 70; });
}

TEST_CASE("What a master wrote stands for the time its server grants, and for ever when that is 0") {
  for (const double granted_s : {60.0, 0.0}) {
    Served s(granted_s);
    const Context reader = s.client();
    {
      const Context master = s.client();
      REQUIRE(modbus_write_register(master.get(), 0, 855) == 1);
    }
    // In the round in which the server knows that the master has gone it also judges what it wrote.
    await([&] { return s.server->connections() == 1; });
    std::uint16_t got = 0;
    for (int i = 0; i < 3; ++i) REQUIRE(modbus_read_registers(reader.get(), 0, 1, &got) == 1);
    CHECK(s.told.of(Signal::kFeedPressureBar).validity == Validity::kValid);
    CHECK(s.told.notices() == 0);
  }
}

TEST_CASE("A server of RTU frames over TCP") {
  Told told;
  ModbusOptions options;
  options.transport = Transport::kRtuTcp;
  options.host = "127.0.0.1";
  options.port = 0;
  options.unit = 17;
  options.routes = {route(Signal::kFeedPressureBar, Table::kHolding, 0)};
  TcpServer server(options, told, nullptr);
  server.step();
  REQUIRE(server.port() != 0);
  const Running running(server);
  ModbusOptions asking = options;
  asking.role = Role::kClient;
  asking.port = server.port();
  const Context c = make_context(asking);
  const FileDescriptor connection = connect_tcp({asking.host, asking.port}, 30, {});
  modbus_set_socket(c.get(), ::dup(connection.get()));  // it closes its own
  modbus_set_response_timeout(c.get(), 30, 0);
  REQUIRE(modbus_write_register(c.get(), 0, 85) == 1);
  await([&] { return told.of(Signal::kFeedPressureBar).value == 85; });
  std::uint16_t got = 0;
  REQUIRE(modbus_read_registers(c.get(), 0, 1, &got) == 1);
  CHECK(got == 85);
}

TEST_CASE("Garbage and lying lengths close their connection and nothing else") {
  Served s;
  const Context c = s.client();
  for (const std::vector<std::uint8_t>& bad :
       {std::vector<std::uint8_t>(300, 0xA5), std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 1},
        std::vector<std::uint8_t>{0, 1, 0, 0, 0xff, 0xff, 1},
        std::vector<std::uint8_t>{0, 1, 0, 7, 0, 6, 1, 3}}) {
    const FileDescriptor fd = s.raw();
    send_all(fd, bad);
    CHECK(closed_by_peer(fd));
  }
  CHECK(count(*s.server, "frames_bad") == 4);
  REQUIRE(modbus_write_register(c.get(), 0, 700) == 1);
  CHECK(s.told.of(Signal::kFeedPressureBar).value == doctest::Approx(70));
}

TEST_CASE("A frame may come byte by byte or several at once; half a frame changes nothing") {
  Served s;
  const FileDescriptor fd = s.raw();
  const std::vector<std::uint8_t> frame = {0, 9, 0, 0, 0, 6, 1, 6, 0, 0, 0, 100};
  for (std::size_t i = 0; i + 1 < frame.size(); ++i) send_all(fd, {frame[i]});
  const Context c = s.client();
  REQUIRE(modbus_write_register(c.get(), 0, 700) == 1);  // the half frame holds nobody up
  CHECK(s.told.of(Signal::kFeedPressureBar).value == doctest::Approx(70));
  send_all(fd, {frame.back()});
  await([&] { return s.told.total() == 2; });
  await([&] { return s.told.of(Signal::kFeedPressureBar).value == doctest::Approx(10); });

  std::vector<std::uint8_t> twice = frame;
  twice.insert(twice.end(), frame.begin(), frame.end());
  send_all(fd, twice);
  await([&] { return s.told.total() == 4; });
}

TEST_CASE("A peer has 8 places: its own silent ones make room for its next, who writes stays") {
  Served s;
  const Context c = s.client();
  REQUIRE(modbus_write_register(c.get(), 0, 1) == 1);
  std::vector<FileDescriptor> flood;
  for (int i = 0; i < 100; ++i) flood.push_back(s.raw());
  await([&] { return count(*s.server, "evicted_connections") == 100 - 7; });
  await([&] { return s.server->connections() == 8; });
  REQUIRE(modbus_write_register(c.get(), 0, 700) == 1);
  CHECK(s.told.notices() <= 3);
  flood.clear();
  await([&] { return s.server->connections() == 1; });
  const Context late = s.client();
  CHECK(modbus_write_register(late.get(), 0, 10) == 1);
}

TEST_CASE("All places held by connections that ask now and then: the one silent longest makes room") {
  Served s;
  std::vector<FileDescriptor> held;
  for (int i = 0; i < 32; ++i) {
    held.push_back(s.raw(2 + i / 8));
    await([&] { return s.server->connections() == held.size(); });
    send_all(held.back(), {0, 1, 0, 0, 0, 6, 1, 3, 0, 0, 0, 1});
    std::uint8_t answer[11];
    REQUIRE(::recv(held.back().get(), answer, sizeof answer, MSG_WAITALL) == sizeof answer);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the server's clock counts milliseconds
  }
  const Context simulator = s.client();
  REQUIRE(modbus_write_register(simulator.get(), 0, 700) == 1);
  CHECK(s.server->connections() == 32);
  CHECK(closed_by_peer(held.front()));
  CHECK(count(*s.server, "evicted_connections") == 1);
  CHECK(count(*s.server, "rejected_connections") == 0);
}

TEST_CASE("Only allowed networks may connect") {
  const Network net{"192.168.1.0/24", {192, 168, 1, 0}, 24},
      v6{"fd00::/8", {0xfd, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 8};
  std::vector<std::uint8_t> far(16, 1), local6(16, 0);
  far[0] = 0xfd;
  local6[15] = 1;
  CHECK(allowed({192, 168, 1, 77}, {v6, net}));
  CHECK_FALSE(allowed({192, 168, 2, 77}, {v6, net}));
  CHECK(allowed(far, {v6, net}));
  CHECK_FALSE(allowed({127, 0, 0, 1}, {net}));
  CHECK(allowed({127, 0, 0, 1}, {}));
  CHECK(allowed(local6, {}));
  CHECK_FALSE(allowed({192, 168, 1, 77}, {}));
  CHECK(allowed({1, 2, 3, 4}, {Network{"0.0.0.0/0", {0, 0, 0, 0}, 0}}));
}

TEST_CASE("A port in use is told and tried again") {
  Served s;
  ModbusOptions options = s.options;
  options.port = s.server->port();
  Told told;
  TcpServer second(options, told, nullptr);
  second.step();
  CHECK(told.notices() == 1);
  CHECK(second.port() == 0);
}
