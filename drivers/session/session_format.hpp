// Bytes of a session file.
#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <string>
#include <string_view>

#include "rigsound/session/session_writer.hpp"

namespace rigsound::session {

constexpr std::string_view kSessionTitle = "rigsound-session";
enum class ChunkKind : std::uint32_t {
  kChanges = 0x43534752,  ///< "RGSC": changes of state
  kSkip = 0x4b534752,     ///< "RGSK": before block `blocks` time went by for so many blocks (a varint)
  kEnd = 0x45534752,      ///< "RGSE": the run ended in order; no payload
};

/// All little-endian. `check` covers `blocks` and the payload.
struct ChunkHead {
  std::uint32_t magic = 0;   ///< ChunkKind
  std::uint32_t size = 0;    ///< of the payload, bytes
  std::uint32_t check = 0;   ///< CRC-32
  std::uint64_t blocks = 0;  ///< rendered when the chunk was written
};
constexpr std::size_t kChunkHeadBytes = 20;
constexpr std::uint32_t kMostChunkBytes = 8 << 20;  ///< the daemon writes two small ones a second

struct Chunk {
  ChunkKind kind = ChunkKind::kChanges;
  std::uint64_t blocks = 0;
  std::string payload;
};

std::string chunk_bytes(const Chunk& chunk);

/// Reads the chunk that comes next. Returns false when there is no whole, sound chunk.
bool read_chunk(std::istream& in, Chunk& chunk);

/// The bytes that end a file whose run ended in order.
bool is_end(const std::string& last_bytes);

constexpr std::size_t kMostHeaderBytes = 4096;
constexpr std::string_view kAfterCrash =
    "after_crash";  ///< a line of the header, 1: SessionHeader::after_crash

std::string header_text(const SessionHeader& header);

/// The lines of a header by their first word; `at` moves behind the empty line that ends it.
std::map<std::string, std::string> header_lines(const std::string& bytes, std::size_t& at);

/// Seven bits a byte, least significant first.
void put_varint(std::string& out, std::uint64_t value);
bool get_varint(std::string_view& in, std::uint64_t& value);
void put_u32(std::string& out, std::uint32_t value);
bool get_u32(std::string_view& in, std::uint32_t& value);

}  // namespace rigsound::session
