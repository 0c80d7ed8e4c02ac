#include "rigsound/log/modbus_capture.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <string>

#include "log/capture_file.hpp"
#include "log/ip_packet.hpp"
#include "log/modbus_conversation.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

HostPort address_of(const Endpoint& end) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  ::inet_ntop(end.v6 ? AF_INET6 : AF_INET, end.address.data(), text.data(), text.size());
  return {text.data(), end.port};
}

}  // namespace

class ModbusCapture::Streams {
 public:
  explicit Streams(std::vector<ServerPort> servers) : known_(std::move(servers)) {}

  void add(const TcpPacket& packet, std::int64_t time_ns) {
    const bool to_server = heads_for_server(packet);
    const auto key =
        to_server ? std::make_pair(packet.from, packet.to) : std::make_pair(packet.to, packet.from);
    const Framing framing = is_rtu(key.second.port) ? Framing::kRtu : Framing::kMbap;
    Conversation& c = conversations_.try_emplace(key, framing).first->second;
    FrameStream& stream = to_server ? c.to_server : c.to_client;
    if (!stream.add(packet)) ++counts.other;
    for (auto frame = stream.next(); !frame.empty(); frame = stream.next())
      to_server ? c.request(frame) : take_answer(c, frame, key.second, time_ns);
  }

  std::deque<TimedExchange> ready;
  CaptureCounts counts;

 private:
  bool heads_for_server(const TcpPacket& p) {
    if (p.syn) servers_[p.ack ? std::make_pair(p.to, p.from) : std::make_pair(p.from, p.to)] = true;
    if (servers_.count({p.from, p.to}) != 0) return true;
    if (servers_.count({p.to, p.from}) != 0) return false;
    if (is_known(p.to.port) != is_known(p.from.port)) return is_known(p.to.port);
    if (p.to.port == modbus::kPort || p.from.port == modbus::kPort) return p.to.port == modbus::kPort;
    return p.to.port < p.from.port;
  }

  bool is_known(int port) const {
    return std::any_of(known_.begin(), known_.end(), [port](const ServerPort& s) { return s.port == port; });
  }
  /// At a port of the rig what the rig says, elsewhere what it says of all its servers.
  bool is_rtu(int port) const {
    const auto rtu = [](const ServerPort& s) { return s.rtu_frames; };
    const bool all_rtu = !known_.empty() && std::all_of(known_.begin(), known_.end(), rtu);
    if (!is_known(port)) return all_rtu;
    return std::any_of(known_.begin(), known_.end(),
                       [port](const ServerPort& s) { return s.port == port && s.rtu_frames; });
  }

  void take_answer(Conversation& c, const std::vector<std::uint8_t>& frame, const Endpoint& server,
                   std::int64_t time_ns) {
    std::vector<modbus::Exchange> agreed;
    switch (c.answer(frame, agreed)) {
      case Conversation::Answer::kRefused:
        ++counts.refused;
        return;
      case Conversation::Answer::kUnpaired:
        ++counts.unpaired;
        return;
      case Conversation::Answer::kOtherFunction:
        ++counts.other_functions;
        return;
      case Conversation::Answer::kAgreed:
        break;
    }
    counts.exchanges += agreed.size();
    for (modbus::Exchange& exchange : agreed)
      ready.push_back({time_ns, std::move(exchange), address_of(server)});
  }

  std::vector<ServerPort> known_;
  std::map<std::pair<Endpoint, Endpoint>, Conversation> conversations_;  // by client and server
  std::map<std::pair<Endpoint, Endpoint>, bool> servers_;                // known from their SYN
};

ModbusCapture::ModbusCapture(const LogFile& file, std::vector<ServerPort> servers)
    : file_(std::make_unique<CaptureFile>(file)), streams_(std::make_unique<Streams>(std::move(servers))) {}

ModbusCapture::~ModbusCapture() = default;

bool ModbusCapture::next(TimedExchange& exchange) {
  CapturedPacket captured;
  while (streams_->ready.empty()) {
    if (!file_->next(captured)) return false;
    ++streams_->counts.packets;
    const auto packet = parse_packet(captured.link_type, captured.bytes.data(), captured.bytes.size());
    if (packet)
      streams_->add(*packet, captured.time_ns);
    else
      ++streams_->counts.other;
  }
  exchange = std::move(streams_->ready.front());
  streams_->ready.pop_front();
  return true;
}

double ModbusCapture::share() const { return file_->share(); }

const CaptureCounts& ModbusCapture::counts() const { return streams_->counts; }

}  // namespace rigsound::log
