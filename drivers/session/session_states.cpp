#include "rigsound/session/session_states.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "rigsound/audio/sample_format.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/machine/limits.hpp"
#include "session/session_format.hpp"
#include "session/state_words.hpp"

namespace rigsound::session {
namespace {

/// The lines of the header by their first word; `at` moves behind the empty line that ends it.
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

template <typename Number>
bool read_number(const std::string& text, Number& value) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  return static_cast<bool>(in >> value);
}

SessionHeader parse_header(const std::string& file, const std::string& bytes, std::size_t& at) {
  auto lines = header_lines(bytes, at);
  const std::string format = lines[std::string(kSessionTitle)];
  if (format.empty()) throw InputError(file, "is no session, expected a file written by rigsoundd --session");
  if (format != std::to_string(kSessionFormat) && format != std::to_string(kOldestSessionFormat))
    throw InputError(file, 1, kSessionTitle,
                     "format " + format + " of another version of rigsound, expected " +
                         std::to_string(kSessionFormat) + ": render it with the version that wrote it");
  SessionHeader h;
  h.program = lines["program"];
  h.fingerprint = lines["fingerprint"];
  const auto sample_format = audio::sample_format_by_name(lines["format"]);
  const bool good = read_number(lines["seed"], h.seed) && read_number(lines["sample_rate"], h.sample_rate) &&
                    read_number(lines["block"], h.block) && read_number(lines["channels"], h.channels) &&
                    sample_format && h.sample_rate >= kMinSampleRate && h.sample_rate <= kMaxSampleRate &&
                    h.block >= kChunk && h.block <= kMaxBlock && h.block % kChunk == 0 && h.channels >= 1 &&
                    h.channels <= kMaxChannels;
  if (!good)
    throw InputError(file, "has a damaged header, expected seed, sample_rate, block, channels, format");
  h.format = *sample_format;
  return h;
}

bool get_masks(std::string_view& in, WordMasks& masks) {
  return std::all_of(masks.begin(), masks.end(), [&](std::uint64_t& mask) { return get_varint(in, mask); });
}

}  // namespace

SessionStates::SessionStates(const std::filesystem::path& file) {
  const std::string bytes = InputFile(file, "session").content();
  std::size_t at = 0;
  header_ = parse_header(file.string(), bytes, at);
  read_chunks(file.string(), bytes, at);
  if (changes_.empty() || changes_.front().block != 0)
    throw SessionWithoutState(file.string(), "holds no state for block 0, expected at least one whole chunk");
}

void SessionStates::read_chunks(const std::string& file, const std::string& bytes, std::size_t at) {
  StateWords words{};
  std::uint64_t block = 0;
  for (Chunk chunk; read_chunk(bytes, at, chunk);) {
    blocks_ = chunk.blocks;
    ended_in_order_ = chunk.kind == ChunkKind::kEnd;
    if (chunk.kind == ChunkKind::kSkip) take_skip(file, chunk.blocks, chunk.payload);
    if (chunk.kind != ChunkKind::kChanges) continue;
    std::string_view payload = chunk.payload;
    std::uint64_t step = 0;
    WordMasks changed{};
    while (get_varint(payload, step) && get_masks(payload, changed)) {
      for (std::size_t i = 0; i < words.size(); ++i)
        if (has(changed, i)) get_u32(payload, words[i]);
      block += step;
      changes_.push_back({block, session::state_of(words), skipped()});
    }
  }
  ignored_ = bytes.size() - at;
}

void SessionStates::take_skip(const std::string& file, std::uint64_t block, std::string_view payload) {
  std::uint64_t count = 0;
  const double longest = kLongestSkip_s * header_.sample_rate / header_.block;
  if (!get_varint(payload, count) || static_cast<double>(count) > longest)
    throw InputError(file, "skips over an hour before block " + std::to_string(block) + ", expected less");
  skips_[block] += count;
}

std::uint64_t SessionStates::skipped() const {
  std::uint64_t blocks = 0;
  for (const auto& [before, count] : skips_) blocks += count;
  return blocks;
}

std::uint64_t SessionStates::skipped_before(std::uint64_t number) {
  const auto found = skips_.find(number);
  return found != skips_.end() ? found->second : 0;
}

const MachineState* SessionStates::state_of(std::uint64_t number) {
  if (number >= blocks_) return nullptr;
  if (number == 0) next_ = 0;
  while (next_ < changes_.size() && changes_[next_].block <= number) ++next_;
  return &changes_[next_ - 1].state;
}

}  // namespace rigsound::session
