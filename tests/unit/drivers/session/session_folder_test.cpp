// What is removed from a folder of sessions, and above all what is not.
#include "rigsound/session/session_folder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/session/session_states.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::session;
using namespace rigsound::test;
namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::seconds;

namespace {

using Clock = std::chrono::system_clock;

const Clock::time_point kNoon = Clock::from_time_t(1796040792);  // 2026-11-30 12:13:12 UTC

MachineState drilling(int i) {
  MachineState state;
  state.engine_rpm = static_cast<float>(900 + i);
  return state;
}

enum class Ending { kInOrder, kCrash };

/// A run from `start` on that `tells` so many states.
fs::path record(SessionFolder& folder, Clock::time_point start, seconds length, int tells,
                Ending ending = Ending::kInOrder) {
  const auto writer = folder.begin({}, start);
  MachineState state;
  writer->add(0, state);
  state.output_gain = 0.5F;  // a fade says nothing
  writer->add(1, state);
  for (int i = 0; i < tells; ++i) writer->add(static_cast<std::uint64_t>(i + 2), drilling(i));
  const auto blocks = static_cast<std::uint64_t>(length.count() * 750);
  ending == Ending::kInOrder ? writer->end(blocks) : writer->flush(blocks);
  // Its last write, in the file system's clock.
  const auto ago = Clock::now() - (start + length);
  fs::last_write_time(writer->file(), fs::file_time_type::clock::now() -
                                          std::chrono::duration_cast<fs::file_time_type::duration>(ago));
  return writer->file();
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE(
    "Sessions are named by time to the millisecond, in a folder that is made for them, and never collide") {
  const TemporaryFolder place;
  SessionFolder folder(place.path / "a" / "b", 1 << 20);
  record(folder, kNoon + milliseconds(417), seconds(60), 1);
  record(folder, kNoon + milliseconds(417), seconds(60), 1);
  record(folder, kNoon + milliseconds(9), seconds(60), 1);
  CHECK(names_in(place.path / "a" / "b") == std::vector<std::string>{"2026-11-30T12-13-12.009Z.rigsession",
                                                                     "2026-11-30T12-13-12.417Z.rigsession",
                                                                     "2026-11-30T12-13-12.418Z.rigsession"});
}

TEST_CASE("The oldest sessions go, as many as it takes for a share of the limit to be free") {
  const TemporaryFolder place;
  SessionFolder wide(place.path, 1 << 20);
  std::vector<fs::path> sessions;
  for (int i = 0; i < 8; ++i) sessions.push_back(record(wide, kNoon + seconds(100 * i), seconds(60), 500));
  const std::uint64_t each = fs::file_size(sessions[0]);
  SessionFolder folder(place.path, 4 * each);
  folder.begin({}, kNoon + seconds(900));
  for (int i = 0; i < 8; ++i) CHECK(fs::exists(sessions[static_cast<std::size_t>(i)]) == (i >= 5));
}

TEST_CASE("A crash loop pushes out no longer session: what is short goes first, what told nothing at once") {
  const TemporaryFolder place;
  SessionFolder folder(place.path, 100000);
  const fs::path incident = record(folder, kNoon, seconds(600), 3000);
  REQUIRE(fs::file_size(incident) < 75000);
  std::vector<fs::path> crashes;
  for (int i = 0; i < 200; ++i) crashes.push_back(record(folder, kNoon + seconds(700 + i), seconds(1), 100));
  CHECK(fs::exists(incident));
  CHECK_FALSE(fs::exists(crashes.front()));
  CHECK(fs::exists(crashes.back()));
  for (int i = 0; i < 5; ++i) record(folder, kNoon + seconds(2000 + i), seconds(1), 0);
  int silent = 0;
  for (const std::string& name : names_in(place.path)) silent += name >= "2026-11-30T12-46" ? 1 : 0;
  CHECK(silent == 1);  // the last one is there until the next begins
}

TEST_CASE(
    "What crashed first outlives the crash loop that follows and the runs in order, however short it was") {
  const TemporaryFolder place;
  SessionFolder folder(place.path, 100000);
  const fs::path incident = record(folder, kNoon, seconds(5), 3000, Ending::kCrash);
  REQUIRE(fs::file_size(incident) > 20000);
  std::vector<fs::path> loop;
  for (int i = 0; i < 40; ++i)
    loop.push_back(record(folder, kNoon + seconds(6 + 20 * i), seconds(18), 800, Ending::kCrash));
  CHECK(fs::exists(incident));
  CHECK_FALSE(fs::exists(loop.front()));
  CHECK(fs::exists(loop.back()));
  const fs::path second = record(folder, kNoon + seconds(2000), seconds(60), 800, Ending::kCrash);
  std::vector<fs::path> days;
  for (int i = 0; i < 40; ++i)
    days.push_back(record(folder, kNoon + seconds(3000 + 100 * i), seconds(60), 2000));
  CHECK(fs::exists(incident));
  CHECK(fs::exists(second));
  CHECK_FALSE(fs::exists(days.front()));
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(place.path)) bytes += entry.file_size();
  CHECK(bytes < 100000);
}

TEST_CASE("When only incidents are left the oldest goes: the limit holds") {
  const TemporaryFolder place;
  SessionFolder folder(place.path, 100000);
  std::vector<fs::path> incidents;
  for (int i = 0; i < 10; ++i)
    incidents.push_back(record(folder, kNoon + seconds(1000 * i), seconds(600), 2000, Ending::kCrash));
  CHECK_FALSE(fs::exists(incidents.front()));
  CHECK(fs::exists(incidents.back()));
}

TEST_CASE("A long session in which nothing was told stays: it says that no bus spoke") {
  const TemporaryFolder place;
  SessionFolder folder(place.path, 1 << 20);
  const fs::path silent = record(folder, kNoon, seconds(60), 0);
  record(folder, kNoon + seconds(100), seconds(60), 1);
  CHECK(fs::exists(silent));
}

TEST_CASE("Without a chunk, a session that a crash cut off tells nothing") {
  const TemporaryFolder place;
  SessionFolder folder(place.path, 1 << 20);
  const fs::path file = folder.begin({}, Clock::now())->file();
  CHECK_THROWS_AS(SessionStates{file}, SessionWithoutState);
  folder.begin({}, Clock::now() + seconds(1));
  CHECK_FALSE(fs::exists(file));
}

TEST_CASE("At most a thousand sessions lie in a folder") {
  const TemporaryFolder place;
  SessionFolder folder(place.path, 1 << 30);
  const fs::path first = record(folder, kNoon, seconds(60), 1);
  for (int i = 1; i < 1000; ++i)
    fs::copy_file(
        first, place.path / ("2027-01-01T00-00-00." + std::to_string(1000 + i).substr(1) + "Z.rigsession"));
  record(folder, kNoon + seconds(100), seconds(60), 1);
  CHECK(names_in(place.path).size() == 1000);
  CHECK_FALSE(fs::exists(first));
}

TEST_CASE("Nothing but finished sessions of the daemon's names is removed, whatever the limit") {
  const TemporaryFolder place;
  SessionFolder wide(place.path, 1 << 20);
  const fs::path renamed = place.path / "accident.rigsession";
  fs::rename(record(wide, kNoon, seconds(60), 100), renamed);
  const fs::path no_session =
      place.write("2026-11-30T12-13-12.001Z.rigsession", "my notes of a long morning");
  const fs::path empty = place.write("2026-11-30T12-13-12.002Z.rigsession", "");
  const fs::path other = place.write("notes.txt", "rigsound-session 4\n");
  const fs::path folder_alike = place.path / "2026-11-30T12-13-12.003Z.rigsession";
  fs::create_directory(folder_alike);
  const fs::path link = place.path / "2026-11-30T12-13-12.004Z.rigsession";
  fs::create_symlink(renamed, link);
  const auto under_way = wide.begin({}, kNoon + milliseconds(5));
  under_way->add(0, {});
  under_way->flush(1);
  const fs::path other_version =
      place.write("2026-11-30T12-13-12.006Z.rigsession", "rigsound-session 3\nprogram 0.0.1\n\n");

  SessionFolder(place.path, 1 << 20).begin({}, kNoon + seconds(100));
  CHECK(fs::exists(other_version));  // what it told is not known
  const fs::path finished = record(wide, kNoon + seconds(200), seconds(60), 1);
  SessionFolder(place.path, 4).begin({}, kNoon + seconds(300));
  CHECK_FALSE(fs::exists(finished));
  CHECK_FALSE(fs::exists(other_version));
  for (const fs::path& file : {renamed, no_session, empty, other, folder_alike, link, under_way->file()}) {
    CAPTURE(file);
    CHECK(fs::exists(fs::symlink_status(file)));
  }
}

TEST_CASE("A file instead of the folder is refused and stays as it is") {
  const TemporaryFolder place;
  const fs::path rig = place.write("rig.toml", "[audio]\n");
  CHECK(complaint([&] { SessionFolder(rig, 1); }) ==
        rig.string() + ": is no folder, expected one for sessions, or a new name");
  CHECK(content(rig) == "[audio]\n");
  SessionFolder inside(rig / "sessions", 1);
  CHECK_THROWS_AS(inside.begin({}, kNoon), DeviceError);
}

TEST_CASE("The newest session of a folder is found, a file is itself, a folder of others is refused") {
  const TemporaryFolder place;
  SessionFolder folder(place.path / "s", 1 << 20);
  record(folder, kNoon + seconds(100), seconds(60), 1);
  const fs::path newest = record(folder, kNoon + seconds(200), seconds(60), 1);
  record(folder, kNoon, seconds(60), 1);
  CHECK(newest_session(place.path / "s") == newest);
  CHECK(newest_session(newest) == newest);
  CHECK(newest_session(place.path / "none") == place.path / "none");
  CHECK_THROWS_AS(newest_session(place.path), InputError);
}
