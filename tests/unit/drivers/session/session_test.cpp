// A session gives back what was written, up to the last whole chunk, whatever happened to its end.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <random>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/session/session_states.hpp"
#include "session/session_format.hpp"
#include "session/state_words.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using test::content;
using namespace rigsound::session;
using rigsound::test::complaint;
namespace fs = std::filesystem;

namespace {

struct Folder {
  Folder() : path(fs::temp_directory_path() / ("rigsound_session_" + std::to_string(::getpid()))) {
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  fs::path path;
  fs::path file = path / "run.rigsession";
};

MachineState state(int i) {
  MachineState s;
  s.engine_rpm = static_cast<float>(900 + i * 0.125);
  s.boom[static_cast<std::size_t>(i % kMaxBooms)].feed_pressure_bar = static_cast<float>(i % 200);
  s.boom[1].rattling = i % 3 == 0 ? Rattling::kOpen : Rattling::kClosed;
  s.boom[3].rock = static_cast<std::uint16_t>(i * 7);
  s.by_hand = static_cast<std::uint32_t>(i % 5);
  s.boom[2].by_hand = static_cast<std::uint32_t>(i % 7);
  s.boom[3].controls.attack_factor = 1.0F / static_cast<float>(i + 1);
  return s;
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

FileDescriptor new_file(const fs::path& file) {
  return FileDescriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644));
}

/// State i acts from block 10 i on; a chunk every 5 states.
void write_session(const fs::path& file, int states) {
  SessionHeader header;
  header.program = "0.1.0";
  header.fingerprint = "00ff";
  header.engine = "0123abcd";
  header.seed = 18446744073709551615ULL;
  SessionWriter writer(file, new_file(file), header);
  for (int i = 0; i < states; ++i) {
    writer.add(static_cast<std::uint64_t>(10 * i), state(i));
    if (i % 5 == 4) writer.flush(static_cast<std::uint64_t>(10 * i + 10));
  }
}

void check_states(SessionStates& session) {
  for (std::uint64_t block = 0; block < session.blocks(); ++block) {
    const MachineState* got = session.state_of(block);
    REQUIRE(got != nullptr);
    REQUIRE(words_of(*got) == words_of(state(static_cast<int>(block / 10))));
  }
  CHECK(session.state_of(session.blocks()) == nullptr);
}

}  // namespace

TEST_CASE("Every field of a state survives the way into words and back") {
  for (int i = 0; i < 300; ++i) CHECK(words_of(state_of(words_of(state(i)))) == words_of(state(i)));
  std::mt19937 random(1);
  StateWords words = words_of(MachineState{});
  CHECK(words.size() == kStateWords);
  MachineState all = state_of(words);
  all.boom[kMaxBooms - 1].by_hand = 7;
  CHECK(words_of(all).back() != words.back());  // the last field is the last word: none is forgotten
}

TEST_CASE("A session gives back every state at its block, and its header") {
  const Folder folder;
  write_session(folder.file, 100);
  SessionStates session(folder.file);
  CHECK(session.blocks() == 1000);
  CHECK(session.bytes_ignored() == 0);
  CHECK(session.header().seed == 18446744073709551615ULL);
  CHECK(session.header().fingerprint == "00ff");
  CHECK(session.header().engine == "0123abcd");
  check_states(session);
}

TEST_CASE("A change of one field writes this field and no other, whichever it is") {
  const Folder folder;
  SessionWriter writer(folder.file, new_file(folder.file), {});
  std::vector<StateWords> acting = {words_of(MachineState{})};
  writer.add(0, state_of(acting.back()));
  writer.flush(1);
  for (std::size_t i = 0; i < kStateWords; ++i) {
    CAPTURE(i);
    acting.push_back(acting.back());
    acting.back()[i] ^=
        acting.back()[i] == 0 ? 1 : 2;  // "from the feed" is 2, one rod 1: never to what is nothing
    const std::uint64_t before = writer.bytes();
    writer.add(acting.size() - 1, state_of(acting.back()));
    writer.flush(acting.size());
    // Head of the chunk, step, a mask for every 64 words (7 bits a byte as far as the highest one set), the
    // word.
    const std::size_t masks = (kStateWords + 63) / 64;
    CHECK(writer.bytes() - before == 20 + 1 + (masks - 1) + (i % 64 / 7 + 1) + 4);
  }
  SessionStates session(folder.file);
  REQUIRE(session.blocks() == acting.size());
  for (std::size_t block = 0; block < acting.size(); ++block)
    CHECK(words_of(*session.state_of(block)) == acting[block]);
}

TEST_CASE("Skipped time lies before its block, counts in later changes, and an end in order is told") {
  const Folder folder;
  {
    SessionWriter writer(folder.file, new_file(folder.file), {});
    writer.add(0, state(0));
    writer.add(7, state(1));
    writer.skip(9, 2251);
    writer.add(9, state(2));
    writer.flush(20);
    writer.skip(20, 5);
    writer.skip(20, 6);
    writer.end(30);
  }
  SessionStates session(folder.file);
  CHECK(session.blocks() == 30);
  CHECK(session.skipped() == 2262);
  CHECK(session.ended_in_order());
  CHECK(session.bytes_ignored() == 0);
  SessionChanges changes = session.changes();
  std::vector<std::pair<std::uint64_t, std::uint64_t>> told;  // block, skipped
  for (Change change; changes.next(change);) told.emplace_back(change.block, change.skipped);
  CHECK(told == std::vector<std::pair<std::uint64_t, std::uint64_t>>{
                    {0, 0}, {7, 0}, {9, 2251}, {9, 2251}, {20, 2256}, {20, 2262}});
  std::uint64_t skipped = 0;
  for (std::uint64_t block = 0; block < 31; ++block) skipped += session.skipped_before(block);
  CHECK(skipped == 2262);
  CHECK(session.skipped_before(9) == 2251);
  CHECK(session.skipped_before(20) == 11);

  const std::string whole = content(folder.file);
  write_bytes(folder.file, whole.substr(0, whole.size() - 1));
  CHECK_FALSE(SessionStates(folder.file).ended_in_order());
  CHECK(SessionStates(folder.file).blocks() == 30);
}

TEST_CASE("A skip of over an hour is no skip") {
  const Folder folder;
  SessionWriter writer(folder.file, new_file(folder.file), {});
  writer.add(0, state(0));
  writer.skip(5, 3600 * 750);
  CHECK(SessionStates(folder.file).skipped() == 3600 * 750);
  writer.skip(6, 3600 * 750 + 1);
  CHECK_THROWS_AS(SessionStates{folder.file}, InputError);
}

TEST_CASE("A session of the format before is read, one before that is not") {
  const Folder folder;
  write_session(folder.file, 100);
  std::string bytes = content(folder.file);
  const std::size_t digit = bytes.find(" 5\n");
  REQUIRE(digit != std::string::npos);
  bytes[digit + 1] = '4';
  write_bytes(folder.file, bytes);
  SessionStates session(folder.file);
  check_states(session);
  bytes[digit + 1] = '3';
  write_bytes(folder.file, bytes);
  CHECK_THROWS_AS(SessionStates{folder.file}, InputError);
}

TEST_CASE("Cut off or damaged anywhere, a session gives the whole chunks before") {
  const Folder folder;
  write_session(folder.file, 50);
  const std::string whole = content(folder.file);
  const fs::path cut = folder.path / "cut.rigsession";
  write_session(cut, 5);
  const std::size_t first_chunk_end = content(cut).size();
  int readable = 0;
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    write_bytes(cut, whole.substr(0, size));
    try {
      SessionStates session(cut);
      check_states(session);
      CHECK(session.blocks() % 50 == 0);
      ++readable;
    } catch (const InputError&) {
      CHECK(size < first_chunk_end);
    }
  }
  CHECK(readable > 10);

  std::string damaged = whole;
  damaged[whole.size() - 60] ^= 1;
  write_bytes(cut, damaged);
  SessionStates session(cut);
  CHECK(session.blocks() == 450);
  CHECK(session.bytes_ignored() > 60);
  check_states(session);
}

TEST_CASE("A process killed with SIGKILL leaves everything it had flushed") {
  const Folder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    write_session(folder.file, 52);  // 2 states never flushed
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
  SessionStates session(folder.file);
  CHECK(session.blocks() == 500);
  check_states(session);
}

TEST_CASE("A full disk ends the recording with a word, and what is on it stays readable") {
  const Folder folder;
  const pid_t child = ::fork();
  if (child == 0) {  // a limit on file size stands in for the disk: the same write fails the same way
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    int code = 0;
    try {
      write_session(folder.file, 500);
    } catch (const DeviceError&) {
      code = 3;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 3);
  SessionStates session(folder.file);
  CHECK(session.blocks() >= 50);
  CHECK(session.bytes_ignored() == 0);
  check_states(session);
}

TEST_CASE("A state that no writer writes is refused, with the signal") {
  const Folder folder;
  const auto refusal_of = [&](const StateWords& words) {
    { const SessionWriter header_alone(folder.file, new_file(folder.file), {}); }
    std::string payload(1, '\0');  // block 0, then all words
    for (const std::uint64_t mask : WordMasks{~0ULL, ~0ULL}) put_varint(payload, mask);
    for (const std::uint32_t word : words) put_u32(payload, word);
    write_bytes(folder.file, content(folder.file) + chunk_bytes({ChunkKind::kChanges, 750, payload}));
    return complaint([&] { SessionStates{folder.file}; });
  };
  const std::string head = folder.file.string() + ": state of block 0: ";
  MachineState bad;
  bad.boom[1].rattling = static_cast<Rattling>(7);
  CHECK(refusal_of(words_of({})).empty());
  CHECK(refusal_of(words_of(bad)) == head + "boom 2: rattling: is 7, expected 0...2");
  bad = {};
  bad.engine_rpm = std::nanf("");
  CHECK(refusal_of(words_of(bad)) == head + "holds a number that is not finite, expected numbers");
  StateWords wide = words_of({});
  for (std::uint32_t& word : wide)
    word |= word == 0 ? 0x10000 : 0;  // of an enumeration only the low byte counts
  CHECK(refusal_of(wide) == head + "holds a word too large for its field, expected a smaller one");
}

TEST_CASE("A session whose blocks run backwards, or on and on, is refused") {
  const Folder folder;
  const auto refusal_of = [&](std::uint64_t first_blocks, std::uint64_t blocks, std::uint64_t step) {
    SessionWriter writer(folder.file, new_file(folder.file), {});
    writer.add(0, state(1));
    writer.flush(first_blocks);
    std::string payload;
    put_varint(payload, step);
    payload.append(sizeof(WordMasks) / 8, '\0');  // nothing changes
    write_bytes(folder.file, content(folder.file) + chunk_bytes({ChunkKind::kChanges, blocks, payload}));
    return complaint([&] { SessionStates{folder.file}; });
  };
  const std::uint64_t an_hour = 3600 * 750;
  CHECK(refusal_of(1, 2, 1).empty());
  CHECK(refusal_of(1, 1 + an_hour, 2 * an_hour).empty());
  CHECK(refusal_of(1, std::uint64_t{1} << 62, 1) ==
        folder.file.string() +
            ": chunk of block 4611686018427387904: is damaged, expected block 1 to 2700001");
  CHECK(refusal_of(1, 2 + an_hour, 1) != "");
  CHECK(refusal_of(2, 1, 1) ==
        folder.file.string() + ": chunk of block 1: is damaged, expected block 2 to 2700002");
  CHECK(refusal_of(1, 2, 2 * an_hour) != "");
  CHECK(refusal_of(1, 2, ~std::uint64_t{0}) != "");  // and none runs over
}

TEST_CASE("What is no session is refused") {
  const Folder folder;
  CHECK_THROWS_AS(SessionStates(folder.path / "missing.rigsession"), InputError);
  for (const std::string& text :
       {std::string(), std::string("RIFF....WAVE"), std::string("rigsound-session 1\n\n"),
        "rigsound-session " + std::to_string(kSessionFormat) + "\nseed x\n\n"}) {
    write_bytes(folder.file, text);
    CHECK_THROWS_AS(SessionStates{folder.file}, InputError);
  }
}
