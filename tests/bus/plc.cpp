// plc PORT|DEVICE: a libmodbus device on 127.0.0.1 or, as unit 1, on a serial line. Holding register 0 = 500,
// float32 in the orders ABCD, CDAB, BADC from 2 on, DCBA in input register 8, coil 1 on.
// Prints `listening`, serves until killed.
#include <modbus.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

/// `order` says where the bytes A (most significant) to D of the value go; libmodbus' own setters of 3.1.6 do
/// not agree with their names on little endian machines.
void put(std::uint16_t* registers, float value, const char* order) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  const auto byte = [&](int place) { return bits >> 8 * ('D' - order[place]) & 0xff; };
  registers[0] = static_cast<std::uint16_t>(byte(0) << 8 | byte(1));
  registers[1] = static_cast<std::uint16_t>(byte(2) << 8 | byte(3));
}

void fill(const modbus_mapping_t& registers) {
  registers.tab_registers[0] = 500;
  put(registers.tab_registers + 2, 1499.375F, "ABCD");
  put(registers.tab_registers + 4, 0.625F, "CDAB");
  put(registers.tab_registers + 6, 87.25F, "BADC");
  put(registers.tab_input_registers + 8, 42.5F, "DCBA");
  registers.tab_bits[1] = 1;
}

void serve(modbus_t* device, modbus_mapping_t* registers) {
  unsigned char request[MODBUS_TCP_MAX_ADU_LENGTH];
  for (int size = 0; (size = modbus_receive(device, request)) >= 0;)
    if (size > 0) modbus_reply(device, request, size, registers);
}

int fail(const char* what) { return std::fprintf(stderr, "plc: %s: %s\n", what, modbus_strerror(errno)), 3; }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: plc PORT|DEVICE\n"), 2;
  const std::string where = argv[1];
  const bool serial = where.front() == '/';
  modbus_t* const device = serial ? modbus_new_rtu(where.c_str(), 19200, 'N', 8, 1)
                                  : modbus_new_tcp("127.0.0.1", std::atoi(where.c_str()));
  modbus_set_slave(device, 1);
  int listening = serial ? modbus_connect(device) : modbus_tcp_listen(device, 1);
  if (listening < 0) return fail(argv[1]);
  modbus_mapping_t* const registers = modbus_mapping_new(4, 0, 10, 10);
  fill(*registers);
  std::puts("listening");
  std::fflush(stdout);
  while (serial && errno != EIO && errno != ECONNRESET) serve(device, registers);  // until the line is gone
  while (modbus_tcp_accept(device, &listening) >= 0) {
    serve(device, registers);
    modbus_close(device);
  }
  return fail("accept");
}
