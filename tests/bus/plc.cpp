// plc PORT: a device on 127.0.0.1 with holding register 0 = 855, float32 CDAB 499.375 at 2, coil 1 on.
// Prints `listening`, serves one client after another until killed.
#include <modbus.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: plc PORT\n"), 2;
  modbus_t* const device = modbus_new_tcp("127.0.0.1", std::atoi(argv[1]));
  modbus_mapping_t* const registers = modbus_mapping_new(4, 0, 10, 0);
  int listening = modbus_tcp_listen(device, 1);
  if (listening < 0) return std::perror("plc"), 3;
  registers->tab_registers[0] = 855;
  registers->tab_registers[2] = 0xB000;
  registers->tab_registers[3] = 0x43F9;
  registers->tab_bits[1] = 1;
  std::puts("listening");
  std::fflush(stdout);
  while (modbus_tcp_accept(device, &listening) >= 0) {
    unsigned char request[MODBUS_TCP_MAX_ADU_LENGTH];
    for (int size = 0; (size = modbus_receive(device, request)) >= 0;)
      modbus_reply(device, request, size, registers);
    modbus_close(device);
  }
}
