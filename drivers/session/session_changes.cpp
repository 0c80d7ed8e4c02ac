#include "rigsound/session/session_changes.hpp"

#include <algorithm>
#include <sstream>

#include "rigsound/audio/sample_format.hpp"
#include "rigsound/machine/limits.hpp"
#include "session/session_format.hpp"
#include "session/state_words.hpp"

namespace rigsound::session {
namespace {

constexpr double kLongestChunk_s = 3600;  // the daemon writes two a second, whatever happens

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
  h.engine = lines["engine"];
  const auto sample_format = audio::sample_format_by_name(lines["format"]);
  const bool good = read_number(lines["seed"], h.seed) && read_number(lines["sample_rate"], h.sample_rate) &&
                    read_number(lines["block"], h.block) && read_number(lines["channels"], h.channels) &&
                    sample_format && kSampleRates.holds(h.sample_rate) && kBlocks.holds(h.block) &&
                    kChannelCounts.holds(h.channels);
  if (!good)
    throw InputError(file, "has a damaged header, expected seed, sample_rate, block, channels, format");
  h.format = *sample_format;
  h.after_crash = lines[std::string(kAfterCrash)] == "1";
  return h;
}

std::string start_of(std::istream& in) {
  std::string bytes(kMostHeaderBytes, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  return bytes;
}

bool get_masks(std::string_view& in, WordMasks& masks) {
  return std::all_of(masks.begin(), masks.end(), [&](std::uint64_t& mask) { return get_varint(in, mask); });
}

}  // namespace

SessionChanges::SessionChanges(const InputFile& file)
    : name_(file.name()),
      path_(file.path()),
      in_(path_, std::ios::binary),
      chunk_(std::make_unique<Chunk>()),
      words_(kStateWords) {
  std::size_t at = 0;
  header_ = parse_header(name_, start_of(in_), at);
  in_.seekg(static_cast<std::streamoff>(at));
  end_ = at;
}

SessionChanges::~SessionChanges() = default;

bool SessionChanges::ended_in_order() const { return chunk_->kind == ChunkKind::kEnd; }

bool SessionChanges::next(Change& change) {
  bool skip = false;
  while (!take_change() && !skip) {
    if (!next_chunk()) {
      if (!begun_) fail_without_state();
      return false;
    }
    skip = chunk_->kind == ChunkKind::kSkip && take_skip();
  }
  if (!begun_ && block_ != 0) fail_without_state();
  begun_ = true;
  told_ = skip ? blocks_ : block_;
  change = change_of(told_);
  return true;
}

Change SessionChanges::change_of(std::uint64_t block) const {
  StateWords words;
  std::copy(words_.begin(), words_.end(), words.begin());
  if (const std::string problem = problem_of(words); !problem.empty())
    throw InputError(name_, 0, "state of block " + std::to_string(block), problem);
  return {block, session::state_of(words), skipped_};
}

void SessionChanges::fail_without_state() const {
  throw SessionWithoutState(name_, "holds no state for block 0, expected at least one whole chunk");
}

/// False at the end of the chunk.
bool SessionChanges::take_change() {
  std::uint64_t step = 0;
  WordMasks changed{};
  if (!get_varint(left_, step) || !get_masks(left_, changed)) return false;
  for (std::size_t i = 0; i < words_.size(); ++i)
    if (has(changed, i)) get_u32(left_, words_[i]);
  require_goes_on("state of block", block_ + step, told_, blocks_ + longest_chunk());
  block_ += step;
  return true;
}

bool SessionChanges::next_chunk() {
  Chunk chunk;
  if (!read_chunk(in_, chunk)) return false;
  require_goes_on("chunk of block", chunk.blocks, blocks_, blocks_ + longest_chunk());
  blocks_ = chunk.blocks;
  end_ += kChunkHeadBytes + chunk.payload.size();
  *chunk_ = std::move(chunk);
  left_ = chunk_->kind == ChunkKind::kChanges ? std::string_view(chunk_->payload) : std::string_view();
  return true;
}

/// Returns whether it is to be told: before the first state there is nothing that it interrupts.
bool SessionChanges::take_skip() {
  require_goes_on("skip before block", blocks_, told_, blocks_);
  std::string_view payload = chunk_->payload;
  std::uint64_t count = 0;
  const double longest = kLongestSkip_s * header_.sample_rate / header_.block;
  if (!get_varint(payload, count) || static_cast<double>(count) > longest)
    throw InputError(name_, "skips over an hour before block " + std::to_string(blocks_) + ", expected less");
  skipped_ += count;
  return begun_;
}

std::uint64_t SessionChanges::longest_chunk() const {
  return static_cast<std::uint64_t>(kLongestChunk_s * header_.sample_rate / header_.block);
}

void SessionChanges::require_goes_on(const char* what, std::uint64_t block, std::uint64_t from,
                                     std::uint64_t to) const {
  if (block >= from && block <= to) return;
  throw InputError(name_, 0, what + (" " + std::to_string(block)),
                   "is damaged, expected block " + std::to_string(from) + " to " + std::to_string(to));
}

std::uint64_t SessionChanges::bytes_ignored() const { return std::filesystem::file_size(path_) - end_; }

}  // namespace rigsound::session
