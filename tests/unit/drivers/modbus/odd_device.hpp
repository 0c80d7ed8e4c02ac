// A device with holes, moods and neighbours: Modbus over TCP, or RTU frames over TCP, spoken by hand.
#pragma once

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <atomic>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

#include "drivers/modbus/serial_line.hpp"
#include "modbus/rtu_frame.hpp"
#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::modbus {

struct Moods {
  bool closes_after_each_answer = false;
  bool rtu_frames = false;
  std::map<std::uint16_t, std::uint16_t> holding;  ///< what there is; anything else is a hole
  std::vector<int> silent_units, absent_units;     ///< no answer at all; exception 11
};

class OddDevice {
 public:
  /// `port` 0 takes a free one.
  explicit OddDevice(Moods moods, int port = 0)
      : moods_(std::move(moods)), listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int on = 1;
    ::setsockopt(listening_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::bind(listening_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    REQUIRE(::listen(listening_.get(), 4) == 0);
    socklen_t size = sizeof address;
    ::getsockname(listening_.get(), reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~OddDevice() {
    stop_ = true;
    thread_.join();
  }

  int port() const { return port_; }
  int connections() const { return connections_; }
  int requests(int unit) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = requests_.find(unit);
    return found == requests_.end() ? 0 : found->second;
  }

 private:
  void serve() {
    while (!stop_) {
      if (!readable(listening_.get())) continue;
      const FileDescriptor peer(::accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      ++connections_;
      while (!stop_ && peer && answer(peer.get())) continue;
    }
  }

  static bool readable(int fd) {
    pollfd poll{fd, POLLIN, 0};
    return ::poll(&poll, 1, 5) == 1;
  }

  /// False when the connection ends.
  bool answer(int fd) {
    if (!readable(fd)) return true;
    std::uint8_t frame[260];
    const ssize_t got = ::recv(fd, frame, sizeof frame, 0);
    if (got < 8) return false;
    const std::uint8_t* const request = moods_.rtu_frames ? frame : frame + 6;  // from the unit on
    const int unit = request[0];
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++requests_[unit];
    }
    if (contains(moods_.silent_units, unit)) return true;
    Bytes reply = {request[0]};
    append_pdu(request, reply);
    if (moods_.rtu_frames)
      reply = with_checksum(reply);
    else
      reply.insert(reply.begin(), {frame[0], frame[1], 0, 0, 0, static_cast<std::uint8_t>(reply.size())});
    return ::send(fd, reply.data(), reply.size(), MSG_NOSIGNAL) > 0 && !moods_.closes_after_each_answer;
  }

  void append_pdu(const std::uint8_t* request, Bytes& reply) const {
    const int first = request[2] << 8 | request[3], count = request[4] << 8 | request[5];
    const auto refuse = [&](std::uint8_t code) {
      reply.push_back(static_cast<std::uint8_t>(request[1] | 0x80));
      reply.push_back(code);
    };
    if (contains(moods_.absent_units, request[0])) return refuse(11);
    for (int i = 0; i < count; ++i)
      if (moods_.holding.count(static_cast<std::uint16_t>(first + i)) == 0) return refuse(2);
    reply.push_back(request[1]);
    reply.push_back(static_cast<std::uint8_t>(2 * count));
    for (int i = 0; i < count; ++i) {
      const std::uint16_t value = moods_.holding.at(static_cast<std::uint16_t>(first + i));
      reply.push_back(static_cast<std::uint8_t>(value >> 8));
      reply.push_back(static_cast<std::uint8_t>(value & 0xff));
    }
  }

  static bool contains(const std::vector<int>& units, int unit) {
    return std::find(units.begin(), units.end(), unit) != units.end();
  }

  Moods moods_;
  FileDescriptor listening_;
  int port_ = 0;
  std::atomic<int> connections_{0};
  mutable std::mutex mutex_;
  std::map<int, int> requests_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace rigsound::modbus
