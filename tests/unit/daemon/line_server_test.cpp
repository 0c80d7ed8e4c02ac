#include "line_server.hpp"

#include <doctest/doctest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/socket/tcp_listener.hpp"
#include "rigsound/socket/unix_listener.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

/// Answers in brackets, has `news` when there is some, and ends with "bye".
struct Brackets : Conversation {
  explicit Brackets(const std::string& said, int& missed_by) : unasked(said), missed(missed_by) {}
  std::string answer(const std::string& request) override {
    done = request == "bye";
    if (request != "slow") return "<" + request + ">\n";
    return {};
  }
  std::string late_answer() override { return late; }
  bool wants_news() const override { return !unasked.empty(); }
  std::string news(double) override { return unasked; }
  void news_not_taken(double) override { ++missed; }
  bool over() const override { return done; }

  const std::string& unasked;
  std::string late;
  int& missed;
  bool done = false;
};

struct Served {
  Served()
      : server(listener.take(), {"\n", 10, [this] {
                                   auto conversation = std::make_unique<Brackets>(news, missed);
                                   last = conversation.get();
                                   return conversation;
                                 }}) {}

  FileDescriptor client() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, path.size());
    FileDescriptor fd(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0));
    REQUIRE(::connect(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    return fd;
  }

  std::string path =
      (std::filesystem::temp_directory_path() / ("rigsound_" + std::to_string(::getpid()) + ".sock"))
          .string();
  std::string news;
  int missed = 0;
  Brackets* last = nullptr;  // conversation begun
  UnixListener listener{path};
  LineServer server;
};

void say(const FileDescriptor& fd, const std::string& text) {
  REQUIRE(::send(fd.get(), text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size()));
}

/// What has arrived, "closed" at the end of the stream.
std::string heard(const FileDescriptor& fd) {
  char bytes[4096];
  const ssize_t got = ::recv(fd.get(), bytes, sizeof bytes, 0);
  return got == 0 ? "closed" : std::string(bytes, got > 0 ? static_cast<std::size_t>(got) : 0);
}

}  // namespace

TEST_CASE("Requests in pieces and several at once are answered in turn, to the client that asked") {
  Served s;
  const FileDescriptor a = s.client(), b = s.client();
  say(a, "on");
  say(b, "x\ny\n");
  CHECK(s.server.serve());  // one of them at a time, so that nobody waits for another's many
  CHECK(heard(a).empty());
  CHECK(heard(b) == "<x>\n");
  say(a, "e\n");
  CHECK_FALSE(s.server.serve());
  CHECK(heard(a) == "<one>\n");
  CHECK(heard(b) == "<y>\n");
}

TEST_CASE("All requests of a client that sends no more are answered before it is closed") {
  Served s;
  const FileDescriptor client = s.client();
  say(client, "x\ny\n");
  ::shutdown(client.get(), SHUT_WR);
  while (s.server.serve()) continue;
  s.server.serve();
  CHECK(heard(client) == "<x>\n<y>\n");
  CHECK(heard(client) == "closed");
}

TEST_CASE("A conversation that is over is closed after its last words") {
  Served s;
  const FileDescriptor client = s.client();
  say(client, "bye\nx\n");
  s.server.serve();
  CHECK(heard(client) == "<bye>\n");
  CHECK(heard(client) == "closed");
}

TEST_CASE(
    "News come unasked; a client that does not take them keeps one, misses the others and holds up nobody") {
  Served s;
  const FileDescriptor slow = s.client(), other = s.client();
  s.server.serve();
  s.server.tell_news(0);
  CHECK(heard(other).empty());
  s.news = std::string(100000, 'n') + "\n";
  const auto hear_all = [&] {
    std::size_t bytes = 0;
    for (std::string got = heard(other); !got.empty(); got = heard(other)) bytes += got.size();
    return bytes;
  };
  int rounds = 0;
  std::size_t other_bytes = 0;
  for (; s.missed < 1000 && rounds < 1100; ++rounds) {
    s.server.tell_news(rounds);
    do {
      s.server.serve();
      const std::size_t got = hear_all();
      other_bytes += got;
      if (got == 0) break;
    } while (true);
  }
  CHECK(s.missed == 1000);
  CHECK(other_bytes == rounds * s.news.size());
  std::size_t slow_bytes = 0;
  for (std::string got = heard(slow); !got.empty(); got = heard(slow)) {
    slow_bytes += got.size();
    s.server.serve();
  }
  CHECK(slow_bytes == (rounds - 1000) * s.news.size());  // whole ones, none torn
}

TEST_CASE("When all places are taken the next client gets that of the one that was silent longest") {
  std::string news;
  int missed = 0;
  FileDescriptor listening = listen_tcp({"127.0.0.1", 0});
  const int port = bound_port(listening);
  LineServer server(std::move(listening),
                    {"\n", 10, [&] { return std::make_unique<Brackets>(news, missed); }});
  const auto client = [&](unsigned last) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(0x7f000000 + last);
    FileDescriptor fd(::socket(AF_INET, SOCK_STREAM, 0));
    REQUIRE(::bind(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    REQUIRE(::connect(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    return fd;
  };
  std::vector<FileDescriptor> clients;
  for (unsigned i = 0; i < 32; ++i) {
    clients.push_back(client(2 + i / 8));
    server.serve();
  }
  say(clients[0], "x\n");
  server.serve();
  CHECK(heard(clients[0]) == "<x>\n");
  const FileDescriptor next = client(9);
  server.serve();
  CHECK(heard(clients[1]) == "closed");
  say(next, "y\n");
  say(clients[0], "z\n");
  server.serve();
  CHECK(heard(next) == "<y>\n");
  CHECK(heard(clients[0]) == "<z>\n");
}

TEST_CASE("One process has 8 places: its ninth client takes that of its own that was silent longest") {
  Served s;
  std::vector<FileDescriptor> clients;
  for (int i = 0; i < 9; ++i) {
    clients.push_back(s.client());
    s.server.serve();
    if (i == 7) {
      say(clients[0], "x\n");
      s.server.serve();
      CHECK(heard(clients[0]) == "<x>\n");
    }
  }
  CHECK(heard(clients[1]) == "closed");
  for (const std::size_t stays : {0, 2, 8}) CHECK(heard(clients[stays]).empty());
}

TEST_CASE("A late answer comes when it is there; until then nothing more is asked, and others are served") {
  Served s;
  const FileDescriptor patient = s.client();
  s.server.serve();
  Brackets* const conversation = s.last;
  const FileDescriptor other = s.client();
  say(patient, "slow\nnext\n");
  CHECK_FALSE(s.server.serve());
  std::vector<pollfd> polls;
  s.server.add_polls(polls);
  CHECK(polls[1].fd == -1);
  CHECK(polls[2].fd >= 0);
  for (int i = 0; i < 3; ++i) {
    s.server.tell_news(100 * i);  // it is not idle
    say(other, "o\n");
    CHECK_FALSE(s.server.serve());
    CHECK(heard(other) == "<o>\n");
    CHECK(heard(patient).empty());
  }
  conversation->late = "<late>\n";
  CHECK(s.server.serve());
  CHECK(heard(patient) == "<late>\n");
  s.server.serve();
  CHECK(heard(patient) == "<next>\n");
}

TEST_CASE("A client that asks nothing for too long is closed, unless it is told news") {
  Served s;
  const FileDescriptor idle = s.client(), busy = s.client();
  s.server.serve();
  for (const double now_s : {1000.0, 1005.0, 1009.0, 1011.0}) {
    say(busy, "x\n");
    s.server.serve();
    CHECK(heard(busy) == "<x>\n");
    CHECK(heard(idle) == "");
    s.server.tell_news(now_s);
  }
  CHECK(heard(idle) == "closed");
  s.news = "n\n";
  s.server.tell_news(1015);
  CHECK(heard(busy) == "n\n");
  s.server.tell_news(2000);
  CHECK(heard(busy) == "n\n");
  s.news = "";
  s.server.tell_news(2009);
  CHECK(heard(busy) == "");
  s.server.tell_news(2011);
  CHECK(heard(busy) == "closed");
}

TEST_CASE("A client without an end is closed, the others stay") {
  Served s;
  const FileDescriptor endless = s.client(), other = s.client();
  for (int i = 0; i < 30; ++i) {
    ::send(endless.get(), std::string(4096, 'a').data(), 4096, MSG_NOSIGNAL);
    s.server.serve();
  }
  CHECK(heard(endless) == "closed");
  say(other, "x\n");
  s.server.serve();
  CHECK(heard(other) == "<x>\n");
}

TEST_CASE("A client that floods is closed before it has taken more than 64 KiB of memory, and a few") {
  Served s;
  const FileDescriptor flood = s.client();
  std::size_t sent = 0;
  const std::string much(1 << 20, 'a');
  for (int i = 0; i < 100; ++i) {
    const ssize_t got = ::send(flood.get(), much.data(), much.size(), MSG_NOSIGNAL);
    if (got <= 0) break;
    sent += static_cast<std::size_t>(got);
    s.server.serve();
  }
  CHECK(sent < (1 << 20));  // what the kernel keeps, and a request
}

TEST_CASE("A client that is gone before it has its answer, or before it has asked, leaves its place") {
  for (const char* said : {"", "x\n", "x\ny\n", "slow\n"}) {
    CAPTURE(std::string(said));
    Served s;
    const FileDescriptor stays = s.client();
    {
      const FileDescriptor gone = s.client();
      say(gone, said);
    }
    s.server.serve();
    if (std::string(said) == "slow\n") s.last->late = "<late>\n";  // the others are gone by now
    while (s.server.serve()) continue;
    s.server.serve();
    std::vector<pollfd> polls;
    s.server.add_polls(polls);
    REQUIRE(polls.size() == 2);  // the listener's, and of who stays
    say(stays, "z\n");
    s.server.serve();
    CHECK(heard(stays) == "<z>\n");
  }
}

TEST_CASE("A client that leaves in the middle of what it is told leaves its place") {
  Served s;
  FileDescriptor leaves = s.client();
  s.server.serve();
  s.news = std::string(1 << 20, 'n') + "\n";
  s.server.tell_news(0);
  leaves.reset();
  s.server.serve();
  std::vector<pollfd> polls;
  s.server.add_polls(polls);
  CHECK(polls.size() == 1);  // the listener's
}

TEST_CASE("A server waits for requests of who has its answer, for room of who has not") {
  Served s;
  const FileDescriptor quick = s.client();
  s.server.serve();
  const auto events = [&] {
    std::vector<pollfd> polls;
    s.server.add_polls(polls);
    REQUIRE(polls.size() == 2);
    CHECK(polls[0].events == POLLIN);
    return polls[1].events;
  };
  CHECK(events() == POLLIN);
  s.news = std::string(1 << 20, 'n') + "\n";
  s.server.tell_news(0);
  CHECK(events() == POLLOUT);
  std::size_t bytes = 0;
  for (std::string got = heard(quick); !got.empty(); got = heard(quick)) {
    bytes += got.size();
    s.server.serve();
  }
  CHECK(bytes == s.news.size());
  CHECK(events() == POLLIN);
}

TEST_CASE("A request of just under 64 KiB is answered, one that goes on past it is not") {
  for (const std::size_t size : {64 * 1024 - 1, 80 * 1024}) {
    CAPTURE(size);
    Served s;
    const FileDescriptor client = s.client();
    std::string request = std::string(size, 'a') + "\n";
    std::size_t bytes = 0;
    std::string got;
    for (int round = 0; round < 100 && got != "closed" && bytes < size + 3; ++round) {
      const ssize_t sent =
          ::send(client.get(), request.data(), std::min<std::size_t>(request.size(), 8192), MSG_NOSIGNAL);
      if (sent > 0) request.erase(0, static_cast<std::size_t>(sent));
      s.server.serve();
      for (got = heard(client); !got.empty() && got != "closed"; got = heard(client)) bytes += got.size();
    }
    CHECK(bytes == (size < 64 * 1024 ? size + 3 : 0));
    CHECK((got == "closed") == (size > 64 * 1024));
  }
}
