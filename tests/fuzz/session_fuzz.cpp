// Any bytes as a session: read or refused; what is read is written and read again as the same. The mutator
// changes what chunks hold and makes their checksums right.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/session/session_states.hpp"
#include "session/session_format.hpp"

using namespace rigsound;
using namespace rigsound::session;

namespace {

struct Chunk {
  std::uint64_t blocks = 0;
  std::string payload;
};

/// A session in pieces: what stands before its chunks, and the sound ones.
struct Pieces {
  std::string header;
  std::vector<Chunk> chunks;

  explicit Pieces(const std::string& bytes) {
    const std::size_t end = bytes.find("\n\n");
    header = bytes.substr(0, end == std::string::npos ? end : end + 2);
    std::istringstream in(bytes.substr(header.size()));
    for (Chunk next; read_chunk(in, next.blocks, next.payload);) chunks.push_back(next);
  }
  std::string bytes() const {
    std::string all = header;
    for (const Chunk& each : chunks) all += chunk(each.blocks, each.payload);
    return all;
  }
};

void mutate(std::string& text) {
  const std::size_t size = text.size();
  text.resize(size + 64);
  text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
}

std::string rewritten(const fuzz::MemoryFile& session) {
  SessionStates states(session.path());
  fuzz::MemoryFile copy("");
  SessionWriter writer(copy.path(), FileDescriptor(::dup(copy.descriptor())), states.header());
  const auto an_hour = static_cast<std::uint64_t>(3600 * states.header().sample_rate / states.header().block);
  std::uint64_t flushed = 0;
  const auto flush_up_to = [&](std::uint64_t blocks) {
    do writer.flush(flushed = std::min(flushed + an_hour, blocks));
    while (flushed < blocks);
  };
  SessionChanges changes = states.changes();
  for (Change change; changes.next(change);) {
    if (change.block > flushed + an_hour) flush_up_to(change.block - an_hour);
    writer.add(change.block, change.state);
  }
  flush_up_to(states.blocks());
  return copy.content();
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  Pieces session({reinterpret_cast<const char*>(data), size});
  if (session.chunks.empty() || seed % 16 == 0) return LLVMFuzzerMutate(data, size, most);
  Chunk& chosen = session.chunks[seed / 16 % session.chunks.size()];
  if (seed % 4 == 0)
    chosen.blocks ^= std::uint64_t{1} << seed / 64 % 64;
  else
    mutate(chosen.payload);
  if (seed % 16 == 1) session.chunks.push_back(chosen);
  const std::string bytes = session.bytes();
  if (bytes.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file(data, size);
  std::string first;
  if (!fuzz::accepts<InputError>([&] { first = rewritten(file); })) return 0;
  if (rewritten(fuzz::MemoryFile(first)) != first) std::abort();
  return 0;
}
