#include "rigsound/session/session_writer.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "rigsound/device_error.hpp"
#include "session/session_format.hpp"
#include "session/state_words.hpp"

namespace rigsound::session {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void stop(const fs::path& file, int error) {
  throw DeviceError(file.string() + ": session stops: " + std::strerror(error));
}

}  // namespace

SessionWriter::SessionWriter(fs::path file, FileDescriptor fd, const SessionHeader& header)
    : file_(std::move(file)), fd_(std::move(fd)), last_words_(kStateWords) {
  ::flock(fd_.get(), LOCK_EX | LOCK_NB);
  append(header_text(header));
}

void SessionWriter::add(std::uint64_t block, const MachineState& state) {
  const StateWords words = words_of(state);
  WordMasks changed{};
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] != last_words_[i]) mark(changed, i);
  put_varint(changes_, block - last_block_);
  for (const std::uint64_t mask : changed) put_varint(changes_, mask);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (has(changed, i)) put_u32(changes_, words[i]);
  last_words_.assign(words.begin(), words.end());
  last_block_ = block;
}

void SessionWriter::flush(std::uint64_t blocks) {
  append(chunk_bytes({ChunkKind::kChanges, blocks, changes_}));
  changes_.clear();
}

void SessionWriter::skip(std::uint64_t block, std::uint64_t count) {
  flush(block);
  std::string payload;
  put_varint(payload, count);
  append(chunk_bytes({ChunkKind::kSkip, block, payload}));
}

void SessionWriter::end(std::uint64_t blocks) {
  flush(blocks);
  append(chunk_bytes({ChunkKind::kEnd, blocks, {}}));
}

void SessionWriter::append(const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t wrote = ::write(fd_.get(), bytes.data() + done, bytes.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) {
      const int error = errno;
      // Readers ignore a torn end; without it the file is whole.
      [[maybe_unused]] const int cut = ::ftruncate(fd_.get(), static_cast<off_t>(bytes_));
      stop(file_, error);
    }
    done += wrote;
  }
  bytes_ += bytes.size();
}

}  // namespace rigsound::session
