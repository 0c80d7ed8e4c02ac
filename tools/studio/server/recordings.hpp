// The folder of recordings and logs as the page knows it: by id.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "folder.hpp"
#include "http.hpp"

namespace rigsound::studio {

struct RecordingFile {
  std::string id, name;
  std::filesystem::path file;
  std::string hash;  ///< changes with the file
};

class Recordings {
 public:
  /// An empty path: there is no folder, and nothing in it.
  explicit Recordings(const std::filesystem::path& folder) : folder_(folder) {}

  /// Files of the folder itself, links that leave it left out, by name. Thread: any.
  std::vector<RecordingFile> recordings() const;
  std::vector<RecordingFile> logs() const;  ///< without hash

  /// Errors: ApiError 404.
  RecordingFile recording(const std::string& id) const;
  RecordingFile log(const std::string& id) const;

  /// The label track beside a recording, there or not. Errors: ApiError 403 when it is a link out of the
  /// folder.
  std::filesystem::path labels_of(const RecordingFile& recording) const;

  /// The recording that a bank names as its source; nothing when it is not in the folder.
  const RecordingFile* find_source(const std::vector<RecordingFile>& all, const std::string& source) const;

 private:
  Folder folder_;
};

}  // namespace rigsound::studio
