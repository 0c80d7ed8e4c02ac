// A folder of sessions, named by the time they began, bounded in total.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "rigsound/session/session_writer.hpp"

namespace rigsound::session {

/// Files 2026-11-30T09-53-12.417Z.rigsession, UTC: their names sort by time. Whatever else lies in the folder
/// is neither counted nor removed: files that are no session, and sessions that a user has renamed. Thread:
/// CT.
class SessionFolder {
 public:
  /// `limit_bytes`: of all sessions together. Errors: InputError when `path` is no folder but something else.
  SessionFolder(std::filesystem::path path, std::uint64_t limit_bytes);

  std::uint64_t share() const { return limit_bytes_ / 4; }  ///< what one session may take

  /// A new session; the folder is made when it is not there. To make room, sessions under 10 s in which
  /// nothing was told go first. Then, until a share is free and fewer than 1000 are left, each kind oldest
  /// first: those under 10 s that ended in order, the others that did, those under a minute that a crash
  /// ended and that began within a minute after another crash, and last those that a crash ended. What is
  /// being written stays. Errors: DeviceError.
  std::unique_ptr<SessionWriter> begin(const SessionHeader& header,
                                       std::chrono::system_clock::time_point now);

 private:
  std::filesystem::path path_;
  std::uint64_t limit_bytes_;
};

/// The newest session of a folder; a file is itself. Errors: InputError for a folder that holds none. Thread:
/// OFF.
std::filesystem::path newest_session(const std::filesystem::path& path);

}  // namespace rigsound::session
