// Sends a drill's state to a rig's [[udp]]: udp_sender [HOST [PORT [SECONDS]]]. C++17, POSIX sockets.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

int main(int argc, char** argv) {
  const std::string host = argc > 1 ? argv[1] : "127.0.0.1";
  const int port = argc > 2 ? std::atoi(argv[2]) : 1503;
  const double seconds = argc > 3 ? std::atof(argv[3]) : 60;

  const int fd = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  if (fd < 0 || ::inet_pton(AF_INET, host.c_str(), &to.sin_addr) != 1) return 1;

  const auto start = std::chrono::steady_clock::now();
  for (int sequence = 0;; ++sequence) {
    const std::chrono::duration<double> now = std::chrono::steady_clock::now() - start;
    if (now.count() >= seconds) break;
    char text[256];
    const int size = std::snprintf(text, sizeof text,
                                   R"({"engine_rpm":%d,"feed_pressure_bar":%.1f,"percussion":true,)"
                                   R"("rattling":"none","rod_count":2,"seq":%d})",
                                   1500, 90.0, sequence);
    ::sendto(fd, text, static_cast<std::size_t>(size), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // a steady pace: silence makes signals stale
  }
  ::close(fd);
}
