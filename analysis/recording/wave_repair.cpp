#include "recording/wave_repair.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>

namespace rigsound::analysis {
namespace {

constexpr std::int64_t kRiffHead = 12, kChunkHead = 8;
constexpr std::uint32_t kUnknownSize = 0xffffffff;  // libsndfile then reads to the end

std::uint32_t number(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

std::string bytes_of(std::int64_t value) {
  const auto size = static_cast<std::uint32_t>(std::min<std::int64_t>(value, kUnknownSize));
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(size >> shift & 0xff);
  return bytes;
}

std::string read_at(std::ifstream& file, std::int64_t at, std::int64_t count) {
  std::string bytes(static_cast<std::size_t>(count), '\0');
  file.clear();
  file.seekg(at);
  file.read(bytes.data(), count);
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool is_chunk_head(const std::string& head) {
  return static_cast<std::int64_t>(head.size()) == kChunkHead &&
         std::all_of(head.begin(), head.begin() + 4, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) || c == ' ' || c == '_';
         });
}

/// Where the chunk behind one of odd length begins: behind the pad byte, or where that is missing.
struct NextChunk {
  std::int64_t at;
  bool unpadded;
};

NextChunk next_chunk(std::ifstream& file, std::int64_t end, std::uint32_t size) {
  if (size % 2 == 0 || is_chunk_head(read_at(file, end + 1, kChunkHead))) return {end + size % 2, false};
  const bool here = is_chunk_head(read_at(file, end, kChunkHead));
  return {end + (here ? 0 : 1), here};
}

WaveRepair repair_of(const std::string& format, std::int64_t begin, std::int64_t end, std::string fault) {
  const std::string fmt_chunk = "fmt " + bytes_of(static_cast<std::int64_t>(format.size())) + format +
                                std::string(format.size() % 2, '\0');
  const std::int64_t data = end - begin;
  const std::string body =
      "WAVE" + fmt_chunk + "data" + bytes_of(data == kUnknownSize ? kUnknownSize - 1 : data);
  return {"RIFF" + bytes_of(static_cast<std::int64_t>(body.size()) + data) + body, begin, end,
          std::move(fault)};
}

}  // namespace

std::optional<WaveRepair> wave_repair(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string riff = read_at(file, 0, kRiffHead);
  if (riff.size() < kRiffHead || riff.compare(0, 4, "RIFF") != 0 || riff.compare(8, 4, "WAVE") != 0)
    return std::nullopt;
  file.clear();
  const std::int64_t length = file.seekg(0, std::ios::end).tellg();
  std::string format, fault;
  for (std::int64_t at = kRiffHead;;) {
    const std::string head = read_at(file, at, kChunkHead);
    if (!is_chunk_head(head)) return std::nullopt;
    const std::string name = head.substr(0, 4);
    const std::uint32_t size = number(head, 4);
    const std::int64_t begin = at + kChunkHead, end = begin + size;
    if (name == "data" && size == 0 && begin < length)
      return repair_of(format, begin, length, "its header says that it holds no samples, read to its end");
    if (name == "data" && fault.empty()) return std::nullopt;
    if (name == "data") return repair_of(format, begin, std::min(end, length), fault);
    if (end > length) return std::nullopt;
    if (name == "fmt ") format = read_at(file, begin, size);
    const NextChunk next = next_chunk(file, end, size);
    if (next.unpadded) fault = "its '" + name + "' chunk of odd length lacks the pad byte, read without it";
    at = next.at;
  }
}

}  // namespace rigsound::analysis
