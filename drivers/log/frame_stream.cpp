#include "log/frame_stream.hpp"

#include <algorithm>

namespace rigsound::log {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kMbap = 7, kMaxFrame = 260, kMostGaps = 8;

std::size_t frame_size(const Bytes& bytes) { return 6 + (bytes[4] << 8 | bytes[5]); }

bool is_modbus(const Bytes& bytes) {
  return bytes.size() < kMbap ||
         (bytes[2] == 0 && bytes[3] == 0 && frame_size(bytes) > kMbap && frame_size(bytes) <= kMaxFrame);
}

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

bool FrameStream::cut(Bytes& bytes) { return framing_ == Framing::kMbap ? cut_mbap(bytes) : cut_rtu(bytes); }

bool FrameStream::cut_mbap(Bytes& bytes) {
  while (bytes.size() >= kMbap && is_modbus(bytes) && bytes.size() >= frame_size(bytes))
    frames_.push_back(take_front(bytes, frame_size(bytes)));
  if (is_modbus(bytes)) return true;
  bytes.clear();
  return false;
}

bool FrameStream::cut_rtu(Bytes& bytes) {
  for (;;) {
    const auto size = modbus::rtu_frame_size(side_, bytes.data(), bytes.size());
    if (size && (*size == 0 || bytes.size() < *size)) return true;
    const bool good =
        size && modbus::rtu_checksum(bytes.data(), *size - 2) == (bytes[*size - 2] | bytes[*size - 1] << 8);
    if (!good) {
      bytes.clear();
      return false;
    }
    frames_.push_back(with_mbap(take_front(bytes, *size)));
  }
}

Bytes FrameStream::next() {
  if (frames_.empty()) return {};
  Bytes frame = std::move(frames_.front());
  frames_.pop_front();
  return frame;
}

}  // namespace rigsound::log
