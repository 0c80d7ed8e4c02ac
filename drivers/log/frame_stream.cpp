#include "log/frame_stream.hpp"

#include <algorithm>

#include "modbus/tcp_frame.hpp"

namespace rigsound::log {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kMostGaps = 8;

Bytes take_front(Bytes& bytes, std::size_t size) {
  const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(size);
  Bytes front(bytes.begin(), end);
  bytes.erase(bytes.begin(), end);
  return front;
}

/// An RTU frame as it would be with an MBAP header.
Bytes with_mbap(const Bytes& rtu) {
  const std::size_t length = rtu.size() - 2;  // unit and PDU, without the checksum
  Bytes frame = {
      0, 0, 0, 0, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length & 0xff)};
  frame.insert(frame.end(), rtu.begin(), rtu.end() - 2);
  return frame;
}

}  // namespace

bool FrameStream::add(const TcpPacket& p) {
  if (p.syn) {
    expected_ = p.sequence + 1;
    bytes_.clear();
    gaps_.clear();
    return true;
  }
  if (p.size == 0) return true;
  const auto behind = static_cast<std::int32_t>(expected_.value_or(p.sequence) - p.sequence);
  if (behind < 0) {
    if (gaps_.size() == kMostGaps) gaps_.pop_front();
    gaps_.push_back({*expected_, p.sequence, std::move(bytes_)});
    bytes_.clear();
  }
  const std::size_t known = behind > 0 ? behind : 0;
  if (known >= p.size) return fill_gap(p);
  bytes_.insert(bytes_.end(), p.data + known, p.data + p.size);
  expected_ = p.sequence + static_cast<std::uint32_t>(p.size);
  return cut(bytes_);
}

bool FrameStream::fill_gap(const TcpPacket& p) {
  const auto end = p.sequence + static_cast<std::uint32_t>(p.size);
  const auto gap = std::find_if(gaps_.begin(), gaps_.end(), [&](const Gap& g) {
    return g.begin == p.sequence && static_cast<std::int32_t>(g.end - end) >= 0;
  });
  if (gap == gaps_.end()) return true;  // sent again
  gap->bytes.insert(gap->bytes.end(), p.data, p.data + p.size);
  gap->begin = end;
  const bool good = cut(gap->bytes);
  if (gap->begin == gap->end || !good) gaps_.erase(gap);
  return good;
}

bool FrameStream::cut(Bytes& bytes) {
  const bool rtu = framing_ != Framing::kMbap;
  for (;;) {
    const auto size = rtu ? modbus::rtu_frame_size(side_, bytes.data(), bytes.size())
                          : modbus::tcp_frame_size(bytes.data(), bytes.size());
    if (size && (*size == 0 || bytes.size() < *size)) return true;
    if (!size || (rtu && !modbus::rtu_checksum_holds(bytes.data(), *size))) {
      bytes.clear();
      return false;
    }
    const Bytes frame = take_front(bytes, *size);
    frames_.push_back(rtu ? with_mbap(frame) : frame);
  }
}

Bytes FrameStream::next() {
  if (frames_.empty()) return {};
  Bytes frame = std::move(frames_.front());
  frames_.pop_front();
  return frame;
}

}  // namespace rigsound::log
