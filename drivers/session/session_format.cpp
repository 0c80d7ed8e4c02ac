#include "session/session_format.hpp"

#include <zlib.h>

#include <array>
#include <sstream>

#include "rigsound/audio/sample_format.hpp"

namespace rigsound::session {
namespace {

std::uint32_t crc32_of(std::string_view blocks, std::string_view payload) {
  uLong crc = 0;
  for (const std::string_view bytes : {blocks, payload})
    crc = ::crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return static_cast<std::uint32_t>(crc);
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
  std::string counted;
  put_u64(counted, chunk.blocks);
  std::string out;
  put_u32(out, static_cast<std::uint32_t>(chunk.kind));
  put_u32(out, static_cast<std::uint32_t>(chunk.payload.size()));
  put_u32(out, crc32_of(counted, chunk.payload));
  return out.append(counted).append(chunk.payload);
}

bool read_chunk(std::istream& in, Chunk& chunk) {
  std::array<char, kChunkHeadBytes> bytes;
  if (!in.read(bytes.data(), bytes.size())) return false;
  std::string_view rest(bytes.data(), bytes.size());
  ChunkHead head;
  get_u32(rest, head.magic);
  get_u32(rest, head.size);
  get_u32(rest, head.check);
  if (!is_kind(head.magic) || head.size > kMostChunkBytes) return false;
  chunk.kind = static_cast<ChunkKind>(head.magic);
  chunk.payload.resize(head.size);
  if (!in.read(chunk.payload.data(), head.size) || crc32_of(rest, chunk.payload) != head.check) return false;
  return get_u64(rest, chunk.blocks);
}

bool is_end(const std::string& last_bytes) {
  std::istringstream in(last_bytes);
  Chunk chunk;
  return read_chunk(in, chunk) && chunk.kind == ChunkKind::kEnd &&
         in.peek() == std::istringstream::traits_type::eof();
}

std::string header_text(const SessionHeader& h) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << kSessionTitle << ' ' << kSessionFormat << "\nprogram " << h.program << "\nfingerprint "
       << h.fingerprint << "\nengine " << h.engine << "\nseed " << h.seed << "\nsample_rate " << h.sample_rate
       << "\nblock " << h.block << "\nchannels " << h.channels << "\nformat " << audio::name(h.format)
       << '\n';
  if (h.after_crash) text << kAfterCrash << " 1\n";
  text << '\n';
  return text.str();
}

std::map<std::string, std::string> header_lines(const std::string& bytes, std::size_t& at) {
  std::map<std::string, std::string> lines;
  while (at < bytes.size()) {
    const std::size_t end = bytes.find('\n', at);
    if (end == std::string::npos) return lines;
    const std::string line = bytes.substr(at, end - at);
    at = end + 1;
    if (line.empty()) return lines;
    const std::size_t space = line.find(' ');
    lines[line.substr(0, space)] = space == std::string::npos ? "" : line.substr(space + 1);
  }
  return lines;
}

}  // namespace rigsound::session
