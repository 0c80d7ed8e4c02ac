// The page itself: files of one folder, known by name since the start.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "http.hpp"

namespace rigsound::studio {

class Pages {
 public:
  /// Errors: InputError when there is no index.html. Thread: OFF.
  explicit Pages(const std::filesystem::path& folder);

  /// 404 for anything that did not lie in the folder. Thread: any.
  Answer answer(const Request& request) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::filesystem::path> files_;  // by the path that asks for them
};

/// Where the page lies: `wanted` unless empty, else installed, else beside the build. Thread: any.
std::filesystem::path find_pages(const std::filesystem::path& wanted);

}  // namespace rigsound::studio
