#include "rigsound/file/make_folders.hpp"

#include "file/flush.hpp"
#include "rigsound/file/unfinished.hpp"

namespace rigsound {

void make_folders(const std::filesystem::path& folder) {
  std::error_code error;
  const Unfinished in_time([&] {
    std::filesystem::create_directories(folder, error);
    return [] {};
  });
  if (error) file::fail(folder, "cannot be made", error.value());
}

}  // namespace rigsound
