// The client against libmodbus' own server, which dies, lies and returns.
#include "modbus/client.hpp"

#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <termios.h>

#include <cmath>
#include <cstring>

#include "drivers/modbus/bus_harness.hpp"
#include "drivers/modbus/serial_line.hpp"
#include "rigsound/file/file_descriptor.hpp"

using namespace rigsound;
using namespace rigsound::modbus;

namespace {

/// A PLC with 10 holding registers and 4 coils from address 0.
class Plc {
 public:
  explicit Plc(int port = 0) : context_(modbus_new_tcp("127.0.0.1", port)) {
    listening_.reset(modbus_tcp_listen(context_.get(), 1));
    REQUIRE(listening_.get() >= 0);
    mapping_ = modbus_mapping_new(4, 0, 10, 0);
    mapping_->tab_registers[0] = 855;
    mapping_->tab_registers[2] = 0xB000;
    mapping_->tab_registers[3] = 0x43F9;
    mapping_->tab_bits[1] = 1;
    thread_ = std::thread([this] { serve(); });
  }
  ~Plc() {
    ::shutdown(listening_.get(), SHUT_RDWR);
    stop_ = true;
    thread_.join();
    modbus_mapping_free(mapping_);
  }
  int port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(listening_.get(), reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

 private:
  void serve() {
    int fd = listening_.get();
    modbus_set_indication_timeout(context_.get(), 0, 20000);
    while (!stop_ && modbus_tcp_accept(context_.get(), &fd) >= 0) {
      std::uint8_t request[MODBUS_TCP_MAX_ADU_LENGTH];
      int got = 0;
      while (!stop_ && ((got = modbus_receive(context_.get(), request)) >= 0 || errno == ETIMEDOUT))
        if (got > 0) modbus_reply(context_.get(), request, got, mapping_);
      modbus_close(context_.get());
    }
  }

  Context context_;
  FileDescriptor listening_;
  modbus_mapping_t* mapping_ = nullptr;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

ModbusOptions asking(int port) {
  ModbusOptions o;
  o.role = Role::kClient;
  o.address = "127.0.0.1:" + std::to_string(port);
  o.port = port;
  o.unit = 1;
  o.poll_s = 0.005;
  o.routes = {route(Signal::kFeedPressureBar, Table::kHolding, 0, WordType::kUint16, WordOrder::kAbcd, 0.1),
              route(Signal::kEngineRpm, Table::kHolding, 2, WordType::kFloat32, WordOrder::kCdab),
              route(Signal::kPercussion, Table::kCoil, 1)};
  return o;
}

}  // namespace

TEST_CASE("The client reads registers and bits, and tells the loss and the return of the device") {
  auto plc = std::make_unique<Plc>();
  const int port = plc->port();
  Told told;
  Client client({asking(port)}, told, nullptr);
  const Running running(client);
  await([&] { return told.of(Signal::kPercussion).validity == Validity::kValid; });
  CHECK(told.of(Signal::kFeedPressureBar).value == doctest::Approx(85.5));
  CHECK(told.of(Signal::kEngineRpm).value == 499.375);
  CHECK(told.of(Signal::kPercussion).value == 1);
  CHECK(told.ups() == 1);

  plc.reset();
  await([&] { return told.downs() == 1; });
  plc = std::make_unique<Plc>(port);
  await([&] { return told.ups() == 2; });
  CHECK(count(client, "losses") == 1);
}

TEST_CASE("A register the device does not have puts its own signal in doubt and no other") {
  Plc plc;
  ModbusOptions options = asking(plc.port());
  options.routes.push_back(route(Signal::kRodCount, Table::kHolding, 500));
  Told told;
  Client client({options}, told, nullptr);
  const Running running(client);
  await([&] { return told.of(Signal::kRodCount).validity != Validity::kNeverSeen; });
  await([&] { return told.of(Signal::kPercussion).validity == Validity::kValid; });
  CHECK(told.of(Signal::kRodCount).validity == Validity::kErrorValue);
  CHECK(told.of(Signal::kFeedPressureBar).validity == Validity::kValid);
  CHECK(told.downs() == 0);
  CHECK(count(client, "requests_refused") >= 1);
}

TEST_CASE("A device that is not there is told once") {
  int port = 0;
  { port = Plc().port(); }
  Told told;
  Client client({asking(port)}, told, nullptr);
  for (int i = 0; i < 4; ++i) client.step();
  CHECK(told.notices() == 1);
  CHECK(told.ups() == 0);
}

TEST_CASE("On a serial line, answers to what was asked before the link was made are not taken for answers") {
  SerialLine line;
  ModbusOptions options = asking(0);
  options.transport = Transport::kRtu;
  options.address = line.device();
  options.routes.resize(1);
  options.timeout_s = 60;
  const FileDescriptor opened_before(::open(options.address.c_str(), O_RDWR | O_NOCTTY));
  termios raw{};
  ::tcgetattr(opened_before.get(), &raw);
  ::cfmakeraw(&raw);
  REQUIRE(::tcsetattr(opened_before.get(), TCSANOW, &raw) == 0);
  line.say(with_checksum({1, 3, 2, 0, 77}));
  Told told;
  Client client({options}, told, nullptr);
  const Running running(client);
  const Bytes question = with_checksum({1, 3, 0, 0, 0, 1});
  REQUIRE(line.hear(question.size()) == question);
  line.say(with_checksum({1, 3, 2, 3, 87}));
  await([&] { return told.total() >= 1; });
  CHECK(told.of(Signal::kFeedPressureBar).value == doctest::Approx(85.5));
  CHECK(told.downs() == 0);
  line.cut();
}
