#include "rigsound/session/session_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/device_error.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/machine/input_error.hpp"
#include "rigsound/session/session_changes.hpp"
#include "session/session_format.hpp"

namespace rigsound::session {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kNamePattern = "0000-00-00T00-00-00.000Z.rigsession";
constexpr std::size_t kMostSessions = 1000;
constexpr std::time_t kBrief_s = 10, kCrashLoop_s = 60;
constexpr std::uintmax_t kMostSilentBytes = 16 << 10;  // of 10 s of fades and nothing else

std::string name_at(std::chrono::system_clock::time_point time) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const std::time_t seconds = ms / 1000;
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  char second[32], millisecond[8];
  std::strftime(second, sizeof second, "%Y-%m-%dT%H-%M-%S", &utc);
  std::snprintf(millisecond, sizeof millisecond, ".%03d", static_cast<int>(ms % 1000));
  return std::string(second).append(millisecond).append("Z.rigsession");
}

bool named_by_time(std::string_view name) {
  const auto alike = [](char given, char wanted) {
    return wanted == '0' ? given >= '0' && given <= '9' : given == wanted;
  };
  return name.size() == kNamePattern.size() &&
         std::equal(name.begin(), name.end(), kNamePattern.begin(), alike);
}

/// When the session of that name began, s since 1970.
std::time_t begin_s(const std::string& name) {
  std::tm utc{};
  ::strptime(name.c_str(), "%Y-%m-%dT%H-%M-%S", &utc);
  return ::timegm(&utc);
}

struct OldSession {
  fs::path file;
  std::uintmax_t bytes = 0;
  std::time_t begin_s = 0, end_s = 0;
  bool crashed = false;      ///< did not end in order
  bool after_crash = false;  ///< begun soon after one that did not

  /// When the clock was set back meanwhile, how long it was is not known.
  bool under(std::time_t length_s) const { return end_s >= begin_s && end_s - begin_s < length_s; }
};

std::string bytes_at(const FileDescriptor& fd, off_t at, std::size_t size) {
  std::string bytes(size, '\0');
  const ssize_t got = ::pread(fd.get(), bytes.data(), size, std::max<off_t>(0, at));
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// Nothing for what is no regular file, does not begin as a session does, or is being written.
std::optional<OldSession> finished_session(const fs::path& file) {
  const FileDescriptor fd(::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat about {};
  if (!fd || ::fstat(fd.get(), &about) != 0 || !S_ISREG(about.st_mode)) return std::nullopt;
  const std::string head = bytes_at(fd, 0, kMostHeaderBytes);
  if (!begins_with(head, kSessionTitle) || ::flock(fd.get(), LOCK_SH | LOCK_NB) != 0) return std::nullopt;
  std::size_t end = 0;
  auto lines = header_lines(head, end);
  // Sessions of older formats do not tell how they ended.
  const bool tells_end = lines[std::string(kSessionTitle)] == std::to_string(kSessionFormat);
  const bool in_order =
      is_end(bytes_at(fd, about.st_size - static_cast<off_t>(kChunkHeadBytes), kChunkHeadBytes));
  // Twice a second its writer writes.
  return OldSession{file,
                    static_cast<std::uintmax_t>(about.st_size),
                    begin_s(file.filename().string()),
                    about.st_mtime,
                    tells_end && !in_order,
                    lines[std::string(kAfterCrash)] == "1"};
}

/// Of the folder, oldest first.
std::vector<OldSession> sessions_in(const fs::path& folder) {
  std::vector<OldSession> sessions;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (named_by_time(entry.path().filename().string()))
      if (auto session = finished_session(entry.path())) sessions.push_back(std::move(*session));
  std::sort(sessions.begin(), sessions.end(),
            [](const OldSession& a, const OldSession& b) { return a.file < b.file; });
  return sessions;
}

/// Whether neither a bus nor a user said anything in it. Of one that another version wrote nothing is known.
bool tells_nothing(const fs::path& file) {
  try {
    const InputFile input(file, "session");
    SessionChanges changes(input);
    for (Change change; changes.next(change);) {
      change.state.output_gain = MachineState{}.output_gain;  // mute and the daemon's own fades
      if (change.state != MachineState{}) return false;
    }
    return true;
  } catch (const SessionWithoutState&) {
    return true;
  } catch (const InputError&) {
    return false;
  }
}

void remove(const OldSession& session) {
  std::error_code error;
  fs::remove(session.file, error);
}

/// Of sessions, oldest first: what goes first comes first. What a crash loop leaves is worth less than what
/// crashed first.
std::vector<OldSession> in_order_of_worth(const std::vector<OldSession>& sessions) {
  std::array<std::vector<OldSession>, 4> kinds;
  for (const OldSession& session : sessions) {
    const bool again = session.after_crash && session.under(kCrashLoop_s);
    kinds[session.crashed ? (again ? 2 : 3) : (session.under(kBrief_s) ? 0 : 1)].push_back(session);
  }
  std::vector<OldSession> all;
  for (const std::vector<OldSession>& kind : kinds) all.insert(all.end(), kind.begin(), kind.end());
  return all;
}

bool soon_after_a_crash(const std::vector<OldSession>& sessions, std::time_t now_s) {
  return !sessions.empty() && sessions.back().crashed && now_s - sessions.back().end_s < kCrashLoop_s;
}

/// Until a session of `share` bytes fits into the limit.
void make_room(const std::vector<OldSession>& all, std::uintmax_t share, std::uintmax_t limit_bytes) {
  std::vector<OldSession> sessions;
  std::uintmax_t bytes = 0;
  for (const OldSession& session : all) {
    if (session.under(kBrief_s) && session.bytes < kMostSilentBytes && tells_nothing(session.file)) {
      remove(session);
      continue;
    }
    bytes += session.bytes;
    sessions.push_back(session);
  }
  std::size_t count = sessions.size();
  for (const OldSession& session : in_order_of_worth(sessions)) {
    if (bytes + share <= limit_bytes && count < kMostSessions) return;
    remove(session);
    bytes -= session.bytes;
    --count;
  }
}

}  // namespace

SessionFolder::SessionFolder(fs::path path, std::uint64_t limit_bytes)
    : path_(std::move(path)), limit_bytes_(limit_bytes) {
  if (fs::exists(path_) && !fs::is_directory(path_))
    throw InputError(path_.string(), "is no folder, expected one for sessions, or a new name");
}

std::unique_ptr<SessionWriter> SessionFolder::begin(const SessionHeader& header,
                                                    std::chrono::system_clock::time_point now) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) throw DeviceError(path_.string() + ": session cannot be written: " + error.message());
  SessionHeader with_history = header;
  const std::vector<OldSession> sessions = sessions_in(path_);
  with_history.after_crash = soon_after_a_crash(sessions, std::chrono::system_clock::to_time_t(now));
  make_room(sessions, share(), limit_bytes_);
  for (;; now += std::chrono::milliseconds(1)) {
    const fs::path file = path_ / name_at(now);
    FileDescriptor fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    if (fd) return std::make_unique<SessionWriter>(file, std::move(fd), with_history);
    if (errno != EEXIST)
      throw DeviceError(file.string() + ": session cannot be written: " + std::strerror(errno));
  }
}

fs::path newest_session(const fs::path& path) {
  if (!fs::is_directory(path)) return path;
  std::string newest;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    const std::string name = entry.path().filename().string();
    if (named_by_time(name) && name > newest) newest = name;
  }
  if (newest.empty())
    throw InputError(path.string(), "holds no session, expected a folder of rigsoundd --session");
  return path / newest;
}

}  // namespace rigsound::session
