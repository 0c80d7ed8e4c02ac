#include "rigsound/log/modbus_capture.hpp"

#include <pcap/pcap.h>

#include <fstream>
#include <string>

#include "log/modbus_conversation.hpp"
#include "log/tcp_packet.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

constexpr std::uint16_t kModbusPort = 502;

}  // namespace

struct ModbusCapture::File {
  std::string name;
  std::unique_ptr<pcap_t, void (*)(pcap_t*)> pcap{nullptr, ::pcap_close};
  int link_type = 0;
};

class ModbusCapture::Streams {
 public:
  void add(const TcpPacket& packet, std::int64_t time_ns) {
    const bool to_server = heads_for_server(packet);
    const auto key =
        to_server ? std::make_pair(packet.from, packet.to) : std::make_pair(packet.to, packet.from);
    Conversation& c = conversations_[key];
    FrameStream& stream = to_server ? c.to_server : c.to_client;
    if (!stream.add(packet)) ++counts.other;
    for (auto frame = stream.next(); !frame.empty(); frame = stream.next())
      to_server ? c.request(frame) : take_answer(c, frame, time_ns);
  }

  std::deque<TimedExchange> ready;
  CaptureCounts counts;

 private:
  bool heads_for_server(const TcpPacket& p) {
    if (p.syn) servers_[p.ack ? std::make_pair(p.to, p.from) : std::make_pair(p.from, p.to)] = true;
    if (servers_.count({p.from, p.to}) != 0) return true;
    if (servers_.count({p.to, p.from}) != 0) return false;
    if (p.to.port == kModbusPort || p.from.port == kModbusPort) return p.to.port == kModbusPort;
    return p.to.port < p.from.port;
  }

  void take_answer(Conversation& c, const std::vector<std::uint8_t>& frame, std::int64_t time_ns) {
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
    for (modbus::Exchange& exchange : agreed) ready.push_back({time_ns, std::move(exchange)});
  }

  std::map<std::pair<Endpoint, Endpoint>, Conversation> conversations_;  // by client and server
  std::map<std::pair<Endpoint, Endpoint>, bool> servers_;                // known from their SYN
};

bool is_capture(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), "cannot be opened, expected a bus log");
  char magic[4] = {};
  in.read(magic, sizeof magic);
  const std::string found(magic, sizeof magic);
  for (const char* known :
       {"\xd4\xc3\xb2\xa1", "\xa1\xb2\xc3\xd4", "\x4d\x3c\xb2\xa1", "\xa1\xb2\x3c\x4d", "\x0a\x0d\x0d\x0a"})
    if (found == known) return true;
  return false;
}

ModbusCapture::ModbusCapture(const std::filesystem::path& file)
    : file_(std::make_unique<File>()), streams_(std::make_unique<Streams>()) {
  file_->name = file.string();
  char error[PCAP_ERRBUF_SIZE] = {};
  file_->pcap.reset(
      ::pcap_open_offline_with_tstamp_precision(file.c_str(), PCAP_TSTAMP_PRECISION_NANO, error));
  if (!file_->pcap) throw InputError(file_->name, std::string("is no capture: ") + error);
  file_->link_type = ::pcap_datalink(file_->pcap.get());
  if (!carries_ip(file_->link_type))
    throw InputError(file_->name, "has link type " + std::to_string(file_->link_type) +
                                      ", expected Ethernet, Linux cooked, raw IP or loopback");
}

ModbusCapture::~ModbusCapture() = default;

bool ModbusCapture::next(TimedExchange& exchange) {
  while (streams_->ready.empty()) {
    pcap_pkthdr* head = nullptr;
    const u_char* bytes = nullptr;
    const int got = ::pcap_next_ex(file_->pcap.get(), &head, &bytes);
    if (got == PCAP_ERROR_BREAK) return false;
    if (got != 1)
      throw InputError(file_->name, std::string("was cut off: ") + ::pcap_geterr(file_->pcap.get()));
    ++streams_->counts.packets;
    const auto packet = parse_packet(file_->link_type, bytes, head->caplen);
    if (packet)
      streams_->add(*packet, head->ts.tv_sec * std::int64_t{1'000'000'000} + head->ts.tv_usec);
    else
      ++streams_->counts.other;
  }
  exchange = std::move(streams_->ready.front());
  streams_->ready.pop_front();
  return true;
}

const CaptureCounts& ModbusCapture::counts() const { return streams_->counts; }

}  // namespace rigsound::log
