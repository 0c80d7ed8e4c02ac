#include "log/capture_file.hpp"

#include <pcap/dlt.h>

#include <algorithm>

#include "log/line_cursor.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::log {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kMaxRecord = 16 << 20;  // bytes; no packet of a bus is longer
constexpr std::uint32_t kSection = 0x0A0D0D0A, kInterface = 1, kOldPacket = 2, kSimple = 3, kEnhanced = 6;
constexpr std::uint32_t kByteOrderMagic = 0x1A2B3C4D;
constexpr std::uint32_t kOptionName = 2, kOptionResolution = 9, kOptionOffset = 14;

/// The numbers in files are those of LINKTYPE_, which differ from DLT_ for raw IP only.
int link_type_of(std::uint32_t number) {
  constexpr std::uint32_t kRawIpv4 = 228, kRawIpv6 = 229;
  return number == kRawIp || number == kRawIpv4 || number == kRawIpv6 ? DLT_RAW : static_cast<int>(number);
}

std::int64_t nanoseconds(std::uint64_t ticks, std::uint64_t ticks_per_s, std::int64_t offset_s) {
  const auto whole = static_cast<std::int64_t>(
      std::min<std::uint64_t>(ticks / ticks_per_s, static_cast<std::uint64_t>(kMaxSeconds)));
  const std::int64_t seconds =
      std::clamp<std::int64_t>(whole + std::clamp(offset_s, -kMaxSeconds, kMaxSeconds), 0, kMaxSeconds);
  const double part = static_cast<double>(ticks % ticks_per_s) / static_cast<double>(ticks_per_s);
  return seconds * kNano + static_cast<std::int64_t>(part * 1e9 + 0.5);
}

}  // namespace

bool begins_capture(const std::string& start) {
  const std::string found = start.substr(0, 4);
  for (const char* known :
       {"\xd4\xc3\xb2\xa1", "\xa1\xb2\xc3\xd4", "\x4d\x3c\xb2\xa1", "\xa1\xb2\x3c\x4d", "\x0a\x0d\x0d\x0a"})
    if (found == known) return true;
  return false;
}

CaptureFile::CaptureFile(const LogFile& file)
    : name_(file.name()), in_(file.path(), std::ios::binary), bytes_(file.bytes()), left_(bytes_) {
  Bytes start;
  if (!in_ || left_ < 4 || !read(start, 4))
    throw InputError(name_, "is no capture, expected a pcap or a pcapng");
  if (!begins_capture({start.begin(), start.end()}))
    throw InputError(name_, "is no capture, expected a pcap or a pcapng");
  pcapng_ = start[0] == 0x0a;
  if (pcapng_) {
    in_.seekg(0);
    left_ = bytes_;
  } else {
    read_pcap_header(start);
  }
}

bool CaptureFile::read(Bytes& bytes, std::size_t size) {
  if (size > left_) {  // found out before there is room for it
    if (left_ > 0) fail("was cut off");
    return false;
  }
  left_ -= size;
  bytes.resize(size);
  in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (in_.gcount() == 0 && size > 0) return false;
  if (in_.gcount() != static_cast<std::streamsize>(size)) fail("was cut off");
  return true;
}

void CaptureFile::fail(const std::string& what) const {
  throw InputError(name_, what + ", expected a whole capture");
}

std::uint32_t CaptureFile::word16(const Bytes& bytes, std::size_t at) const {
  if (at + 2 > bytes.size()) fail("is damaged");
  return big_endian_ ? static_cast<std::uint32_t>(bytes[at] << 8 | bytes[at + 1])
                     : static_cast<std::uint32_t>(bytes[at + 1] << 8 | bytes[at]);
}

std::uint32_t CaptureFile::word32(const Bytes& bytes, std::size_t at) const {
  const std::uint32_t first = word16(bytes, at), second = word16(bytes, at + 2);
  return big_endian_ ? first << 16 | second : second << 16 | first;
}

void CaptureFile::read_pcap_header(const Bytes& start) {
  big_endian_ = start[0] == 0xa1;
  const bool nano = start[big_endian_ ? 3 : 0] == 0x4d;
  Bytes rest;
  if (!read(rest, 20)) fail("was cut off");
  constexpr std::uint32_t kNoFlags = 0x0FFFFFFF;
  interfaces_ = {{link_type_of(word32(rest, 16) & kNoFlags), {}, nano ? 1'000'000'000U : 1'000'000U, 0}};
}

bool CaptureFile::next(CapturedPacket& packet) { return pcapng_ ? next_pcapng(packet) : next_pcap(packet); }

bool CaptureFile::next_pcap(CapturedPacket& packet) {
  Bytes head;
  if (!read(head, 16)) return false;
  const std::uint32_t size = word32(head, 8);
  if (size > kMaxRecord) fail("is damaged");
  if (size > 0 && !read(packet.bytes, size)) fail("was cut off");
  packet.bytes.resize(size);
  const Interface& all = interfaces_.front();
  const std::uint64_t nano_factor = 1'000'000'000 / all.ticks_per_s;
  packet.time_ns = static_cast<std::int64_t>(word32(head, 0)) * kNano +
                   static_cast<std::int64_t>(word32(head, 4) * nano_factor);
  packet.link_type = all.link_type;
  packet.interface.clear();
  return true;
}

bool CaptureFile::next_block(Block& block) {
  Bytes head;
  if (!read(head, 8)) return false;
  block.type = word32(head, 0);
  if (block.type == kSection) {  // the same in both byte orders
    Bytes magic;
    if (!read(magic, 4)) fail("was cut off");
    big_endian_ = false;
    big_endian_ = word32(magic, 0) != kByteOrderMagic;
    if (word32(magic, 0) != kByteOrderMagic) fail("is damaged");
    in_.seekg(-4, std::ios::cur);
    left_ += 4;
  }
  const std::uint32_t length = word32(head, 4);
  if (length < 12 || length % 4 != 0 || length > kMaxRecord) fail("is damaged");
  Bytes body;
  if (!read(body, length - 8)) fail("was cut off");
  body.resize(length - 12);  // the length stands at the end once more
  block.body = std::move(body);
  return true;
}

bool CaptureFile::next_pcapng(CapturedPacket& packet) {
  Block block;
  while (next_block(block)) {
    if (block.type == kSection) interfaces_.clear();
    if (block.type == kInterface) add_interface(block.body);
    if (take_packet(block, packet)) return true;
  }
  return false;
}

void CaptureFile::add_interface(const Bytes& body) {
  Interface interface;
  interface.link_type = link_type_of(word16(body, 0));
  for (std::size_t at = 8; at + 4 <= body.size();) {
    const std::uint32_t code = word16(body, at), size = word16(body, at + 2);
    if (code == 0 || at + 4 + size > body.size()) break;
    set_option(code, body, at + 4, size, interface);
    at += 4 + (size + 3) / 4 * 4;
  }
  interfaces_.push_back(std::move(interface));
}

void CaptureFile::set_option(std::uint32_t code, const Bytes& body, std::size_t at, std::size_t size,
                             Interface& interface) const {
  if (code == kOptionName)
    interface.name.assign(body.begin() + static_cast<std::ptrdiff_t>(at),
                          body.begin() + static_cast<std::ptrdiff_t>(at + size));
  if (code == kOptionResolution && size >= 1) {
    const unsigned exponent = body[at] & 0x7F;
    const bool binary = (body[at] & 0x80) != 0;
    if (exponent > (binary ? 63U : 19U)) fail("is damaged");
    interface.ticks_per_s = 1;
    for (unsigned i = 0; i < exponent; ++i) interface.ticks_per_s *= binary ? 2 : 10;
  }
  if (code == kOptionOffset && size >= 8) {
    const std::uint64_t first = word32(body, at), second = word32(body, at + 4);
    interface.offset_s = static_cast<std::int64_t>(big_endian_ ? first << 32 | second : second << 32 | first);
  }
}

/// False for a block that holds no packet.
bool CaptureFile::take_packet(const Block& block, CapturedPacket& packet) {
  const bool simple = block.type == kSimple;
  if (!simple && block.type != kEnhanced && block.type != kOldPacket) return false;
  const std::uint32_t number = simple                    ? 0
                               : block.type == kEnhanced ? word32(block.body, 0)
                                                         : word16(block.body, 0);
  if (number >= interfaces_.size()) fail("is damaged");
  const Interface& interface = interfaces_[number];
  const std::size_t data_at = simple ? 4 : 20;
  const std::size_t stated = word32(block.body, simple ? 0 : 12);
  if (block.body.size() < data_at || (!simple && stated > block.body.size() - data_at)) fail("is damaged");
  const std::size_t size = std::min(stated, block.body.size() - data_at);
  const auto data = block.body.begin() + static_cast<std::ptrdiff_t>(data_at);
  packet.bytes.assign(data, data + static_cast<std::ptrdiff_t>(size));
  if (!simple) {
    const std::uint64_t ticks =
        static_cast<std::uint64_t>(word32(block.body, 4)) << 32 | word32(block.body, 8);
    last_ns_ = nanoseconds(ticks, interface.ticks_per_s, interface.offset_s);
  }
  packet.time_ns = last_ns_;
  packet.link_type = interface.link_type;
  packet.interface = interface.name;
  return true;
}

}  // namespace rigsound::log
