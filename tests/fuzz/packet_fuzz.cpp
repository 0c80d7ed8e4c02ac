// Any bytes as packets of a capture: no crash, and no byte is taken from outside the packet. The first byte
// chooses the link type; then come packets, each behind its length.
#include <pcap/dlt.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "fuzz_target.hpp"
#include "log/modbus_conversation.hpp"

using namespace rigsound;

namespace {

constexpr int kLinkTypes[] = {DLT_EN10MB, DLT_LINUX_SLL, DLT_RAW, DLT_NULL};

void feed(log::Conversation& conversation, const log::TcpPacket& packet) {
  log::FrameStream& stream = packet.to.port == 502 ? conversation.to_server : conversation.to_client;
  stream.add(packet);
  std::vector<modbus::Exchange> agreed;
  while (true) {
    const std::vector<std::uint8_t> frame = stream.next();
    if (frame.empty()) return;
    if (&stream == &conversation.to_server)
      conversation.request(frame);
    else
      conversation.answer(frame, agreed);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const int link_type = kLinkTypes[data[0] % std::size(kLinkTypes)];
  log::Conversation conversation;
  for (std::size_t at = 1; at < size;) {
    const std::size_t length = std::min<std::size_t>(data[at], size - at - 1);
    const std::uint8_t* const packet = data + at + 1;
    const auto tcp = log::parse_packet(link_type, packet, length);
    if (tcp && tcp->size > 0 && (tcp->data < packet || tcp->data + tcp->size > packet + length)) std::abort();
    if (tcp) feed(conversation, *tcp);
    at += 1 + length;
  }
  return 0;
}
