// A stop reaches a bus whatever it waits for: each would wait far longer than the test takes.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>

#include "drivers/modbus/bus_harness.hpp"
#include "drivers/modbus/serial_line.hpp"
#include "modbus/client.hpp"
#include "modbus/tcp_server.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/monotonic_time.hpp"
#include "rigsound/socket/tcp_listener.hpp"
#include "rigsound/udp/udp_bus.hpp"

using namespace rigsound;
using modbus::Table;

namespace {

constexpr double kFarLess_s = 20;  // than 60 s, and more than any machine needs

modbus::ModbusOptions patient_client() {
  modbus::ModbusOptions o;
  o.role = modbus::Role::kClient;
  o.unit = 1;
  o.timeout_s = 60;
  o.routes = {modbus::route(Signal::kFeedPressureBar, Table::kHolding, 0)};
  return o;
}

/// Seconds from the stop to the end of the bus's thread, once `asked` has come.
template <class Asked>
double stop_after(Bus& bus, Asked asked) {
  double stopped_s = 0;
  {
    const modbus::Running running(bus);
    asked();
    stopped_s = monotonic_s();
  }
  return monotonic_s() - stopped_s;
}

void wait_readable(int fd) {
  pollfd poll{fd, POLLIN, 0};
  REQUIRE(::poll(&poll, 1, 60000) == 1);
}

}  // namespace

TEST_CASE("A Modbus client that waits 60 s for an answer stops at once") {
  const FileDescriptor plc = listen_tcp({"127.0.0.1", 0});
  for (const modbus::Transport transport : {modbus::Transport::kTcp, modbus::Transport::kRtuTcp}) {
    modbus::ModbusOptions options = patient_client();
    options.transport = transport;
    options.host = "127.0.0.1";
    options.port = bound_port(plc);
    modbus::Told told;
    modbus::Client client({options}, told, nullptr);
    FileDescriptor accepted;
    CHECK(stop_after(client, [&] {
            wait_readable(plc.get());
            accepted.reset(::accept(plc.get(), nullptr, nullptr));
            wait_readable(accepted.get());  // the question
          }) < kFarLess_s);
    CHECK(told.notices() == 0);
  }
}

TEST_CASE("A Modbus client that gets an answer byte by byte, a byte in a while, stops at once") {
  const FileDescriptor plc = listen_tcp({"127.0.0.1", 0});
  modbus::ModbusOptions options = patient_client();
  options.host = "127.0.0.1";
  options.port = bound_port(plc);
  modbus::Told told;
  modbus::Client client({options}, told, nullptr);
  FileDescriptor accepted;
  CHECK(stop_after(client, [&] {
          wait_readable(plc.get());
          accepted.reset(::accept(plc.get(), nullptr, nullptr));
          wait_readable(accepted.get());
          REQUIRE(::send(accepted.get(), "\0\1", 2, MSG_NOSIGNAL) == 2);
        }) < kFarLess_s);
}

TEST_CASE("A Modbus client on a serial line stops at once") {
  modbus::SerialLine line;
  modbus::ModbusOptions options = patient_client();
  options.transport = modbus::Transport::kRtu;
  options.address = line.device();
  modbus::Told told;
  modbus::Client client({options}, told, nullptr);
  CHECK(stop_after(client, [&] { line.hear(8); }) < kFarLess_s);
}

TEST_CASE("A stop that comes before the run ends it before its first round") {
  modbus::ModbusOptions options = patient_client();
  options.host = "192.0.2.1";  // TEST-NET-1: nobody answers
  options.port = 502;
  modbus::Told told;
  modbus::Client client({options}, told, nullptr);
  client.stop();
  client.run();
  CHECK(client.stopped());
  CHECK(told.notices() == 0);
}

TEST_CASE("A wait ends with its descriptor, with the stop, or with its time") {
  StopEvent stop;
  int ends[2] = {-1, -1};
  REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) == 0);
  const FileDescriptor a(ends[0]), b(ends[1]);
  CHECK_FALSE(stop.wait(a.get(), POLLIN, 0));
  REQUIRE(::send(b.get(), "x", 1, MSG_NOSIGNAL) == 1);
  CHECK(stop.wait(a.get(), POLLIN, -1));
  CHECK_FALSE(stop.is_set());
  stop.set();
  CHECK(stop.is_set());
  CHECK_FALSE(stop.wait(a.get(), POLLIN, -1));  // the stop comes first, also of both
  CHECK_FALSE(stop.wait(-1, 0, -1));
}

TEST_CASE("A name that no server knows is a problem of its own, a number needs none") {
  CHECK(bound_port(listen_tcp({"127.0.0.1", 0})) > 0);
  CHECK(bound_port(listen_udp({"::1", 0})) > 0);
  CHECK(bound_port(listen_tcp({"localhost", 0})) > 0);
}
