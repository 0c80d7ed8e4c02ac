// Serves simulators that write to us: many connections, one thread, nobody can hold it up or keep others out.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "modbus/context.hpp"
#include "modbus/modbus_server.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/socket/places.hpp"

namespace rigsound::modbus {

constexpr Places kPlaces;
constexpr std::int64_t kIdle_ms = 60'000;  ///< a connection without a request for so long is closed

class TcpServer final : public ModbusServer {
 public:
  TcpServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap);
  void step() override;

  int port() const;  ///< bound, which matters when the options say 0; 0: not listening
  std::size_t connections() const { return open_.load(std::memory_order_relaxed); }  ///< Thread: any

 private:
  struct Connection {
    FileDescriptor fd;
    std::string peer;
    std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> bytes{};
    std::size_t filled = 0;
    std::int64_t last_ms = 0;
    bool wrote = false;  // it is a master: what it wrote stands while it is there
  };

  /// A whole frame at the beginning of a connection's bytes.
  struct Frame {
    std::size_t size = 0;      ///< 0: more must come
    std::size_t pdu_size = 0;  ///< from the function code on
  };
  std::optional<Frame> first_frame(const Connection& connection) const;  ///< nothing: no Modbus
  void note_masters();
  void listen();
  void accept_all();
  void make_room(const std::string& peer);
  bool serve(Connection& connection);
  bool answer_whole_frames(Connection& connection);
  void bad_frame(const Connection& connection, const char* what);
  void forget_closed();

  Context context_;  // builds the answers; its socket is lent by the connection being served
  FileDescriptor listening_;
  std::vector<Connection> connections_;
  std::atomic<std::size_t> open_{0};
  std::int64_t gone_ms_ = 0;  // when the last master went; 0: there is one, or there was none
  bool had_master_ = false;
};

}  // namespace rigsound::modbus
