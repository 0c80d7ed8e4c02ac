#include "recordings.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "rigsound/analysis/recording.hpp"
#include "rigsound/config/sha256.hpp"
#include "rigsound/file/ending.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

bool is_log(const fs::path& file) {
  static const std::set<std::string> kExtensions = {".log", ".asc", ".trc", ".pcap", ".pcapng", ".csv"};
  return kExtensions.count(ending_of(file.extension() == ".gz" ? file.stem() : file)) > 0;
}

/// Size, time of the last write and bytes from all over the file: hashing an hour takes longer than showing
/// it.
std::string hash_of(const fs::path& file) {
  constexpr int kPieces = 64;
  constexpr std::size_t kPieceBytes = 4096;
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return "absent";
  config::Sha256 hash;
  const auto feed = [&hash](auto value) { hash.update(&value, sizeof value); };
  feed(status.st_size), feed(status.st_mtim.tv_sec), feed(status.st_mtim.tv_nsec), feed(status.st_ino);
  std::ifstream in(file, std::ios::binary);
  std::string piece(kPieceBytes, '\0');
  for (int i = 0; i < kPieces && in; ++i) {
    in.seekg(status.st_size * i / kPieces);
    in.read(piece.data(), kPieceBytes);
    hash.update(piece.data(), static_cast<std::size_t>(in.gcount()));
    in.clear();
  }
  return hash.hex().substr(0, 12);
}

template <class Wanted>
std::vector<RecordingFile> files_of(const Folder& folder, Wanted wanted) {
  std::vector<RecordingFile> files;
  std::error_code error;
  if (folder.path().empty() || !fs::is_directory(folder.path(), error)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path(), error)) {
    const std::string name = entry.path().filename().string();
    if (name.front() == '.' || !wanted(entry.path())) continue;
    if (!entry.is_regular_file(error) || !folder.holds(entry.path())) continue;
    files.push_back({id_of(name), name, entry.path(), ""});
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return files;
}

RecordingFile found(const std::vector<RecordingFile>& files, const std::string& id, const char* kind) {
  for (const RecordingFile& file : files)
    if (file.id == id) return file;
  throw ApiError(404, std::string("there is no such ") + kind);
}

}  // namespace

std::vector<RecordingFile> Recordings::recordings() const {
  std::vector<RecordingFile> files = files_of(folder_, analysis::is_recording_name);
  for (RecordingFile& file : files) file.hash = hash_of(file.file);
  return files;
}

std::vector<RecordingFile> Recordings::logs() const { return files_of(folder_, is_log); }

RecordingFile Recordings::recording(const std::string& id) const {
  RecordingFile file = found(files_of(folder_, analysis::is_recording_name), id, "recording");
  file.hash = hash_of(file.file);
  return file;
}

RecordingFile Recordings::log(const std::string& id) const { return found(logs(), id, "log"); }

fs::path Recordings::labels_of(const RecordingFile& recording) const {
  return folder_.inside(fs::path(recording.name).replace_extension(".txt"));
}

const RecordingFile* Recordings::find_source(const std::vector<RecordingFile>& all,
                                             const std::string& source) const {
  const std::string name = fs::path(source).filename().string();
  const auto file = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return file == all.end() ? nullptr : &*file;
}

}  // namespace rigsound::studio
