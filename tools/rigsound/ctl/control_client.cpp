#include "ctl/control_client.hpp"

#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "rigsound/device_error.hpp"

namespace rigsound::tools {

ControlClient::ControlClient(const std::string& socket)
    : socket_(socket), fd_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (socket.size() >= sizeof address.sun_path)
    throw DeviceError(socket + ": the path is too long for a socket");
  socket.copy(address.sun_path, socket.size());
  if (::connect(fd_.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw DeviceError(socket + ": no rigsoundd answers there: " + std::strerror(errno));
}

Json ControlClient::ask(const Json& request) {
  const std::string line = config::json_line(request) + "\n";
  if (::send(fd_.get(), line.data(), line.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(line.size()))
    throw DeviceError(socket_ + ": rigsoundd has gone");
  Json answer = next_object();
  if (!answer.value("ok", false)) throw std::runtime_error(answer.value("error", "refused"));
  return answer;
}

Json ControlClient::next_object() {
  Json object = config::parsed_json(next_line());
  if (!object.is_object())
    throw DeviceError(socket_ + ": what answers there is no rigsoundd: its line is no JSON object");
  return object;
}

std::string ControlClient::next_line() {
  std::size_t end = 0;
  while ((end = unread_.find('\n')) == std::string::npos) {
    std::array<char, 65536> bytes{};
    const ssize_t got = ::recv(fd_.get(), bytes.data(), bytes.size(), 0);
    if (got <= 0) throw DeviceError(socket_ + ": rigsoundd has gone");
    unread_.append(bytes.data(), static_cast<std::size_t>(got));
  }
  std::string line = unread_.substr(0, end);
  unread_.erase(0, end + 1);
  return line;
}

}  // namespace rigsound::tools
