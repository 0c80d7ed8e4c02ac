#include "session/session_format.hpp"

#include <array>
#include <sstream>

#include "rigsound/audio/sample_format.hpp"

namespace rigsound::session {
namespace {

// CRC-32 of ISO 3309, reflected polynomial 0xEDB88320.
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
  }
  return ~crc;
}

bool is_kind(std::uint32_t magic) {
  const auto kind = static_cast<ChunkKind>(magic);
  return kind == ChunkKind::kChanges || kind == ChunkKind::kSkip || kind == ChunkKind::kEnd;
}

void put_u64(std::string& out, std::uint64_t value) {
  put_u32(out, static_cast<std::uint32_t>(value));
  put_u32(out, static_cast<std::uint32_t>(value >> 32));
}

bool get_u64(std::string_view& in, std::uint64_t& value) {
  std::uint32_t low = 0, high = 0;
  if (!get_u32(in, low) || !get_u32(in, high)) return false;
  value = static_cast<std::uint64_t>(high) << 32 | low;
  return true;
}

}  // namespace

void put_u32(std::string& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>(value >> shift & 0xff));
}

bool get_u32(std::string_view& in, std::uint32_t& value) {
  if (in.size() < 4) return false;
  value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(in[i])) << (8 * i);
  in.remove_prefix(4);
  return true;
}

void put_varint(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>((value & 0x7f) | 0x80));
  out.push_back(static_cast<char>(value));
}

bool get_varint(std::string_view& in, std::uint64_t& value) {
  value = 0;
  for (int shift = 0; shift < 64 && !in.empty(); shift += 7) {
    const auto byte = static_cast<unsigned char>(in.front());
    in.remove_prefix(1);
    value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if ((byte & 0x80) == 0) return true;
  }
  return false;
}

std::string chunk_bytes(const Chunk& chunk) {
  std::string checked;
  put_u64(checked, chunk.blocks);
  checked.append(chunk.payload);
  std::string out;
  put_u32(out, static_cast<std::uint32_t>(chunk.kind));
  put_u32(out, static_cast<std::uint32_t>(chunk.payload.size()));
  put_u32(out, crc32(checked));
  return out.append(checked);
}

bool read_chunk(std::string_view bytes, std::size_t& at, Chunk& chunk) {
  if (at > bytes.size()) return false;
  std::string_view in = bytes.substr(at);
  ChunkHead head;
  const bool headed = get_u32(in, head.magic) && is_kind(head.magic) && get_u32(in, head.size) &&
                      get_u32(in, head.check) && in.size() >= 8 && in.size() - 8 >= head.size;
  if (!headed || crc32(in.substr(0, 8 + head.size)) != head.check) return false;
  chunk.kind = static_cast<ChunkKind>(head.magic);
  get_u64(in, chunk.blocks);
  chunk.payload = in.substr(0, head.size);
  at += kChunkHeadBytes + head.size;
  return true;
}

bool is_end(std::string_view last_bytes) {
  Chunk chunk;
  std::size_t at = 0;
  return read_chunk(last_bytes, at, chunk) && chunk.kind == ChunkKind::kEnd && at == last_bytes.size();
}

std::string header_text(const SessionHeader& h) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << kSessionTitle << ' ' << kSessionFormat << "\nprogram " << h.program << "\nfingerprint "
       << h.fingerprint << "\nseed " << h.seed << "\nsample_rate " << h.sample_rate << "\nblock " << h.block
       << "\nchannels " << h.channels << "\nformat " << audio::name(h.format)
       << (h.after_crash ? kAfterCrashLine : "\n") << '\n';
  return text.str();
}

}  // namespace rigsound::session
