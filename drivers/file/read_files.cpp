#include "rigsound/file/read_files.hpp"

#include "rigsound/machine/input_error.hpp"

namespace rigsound {
namespace fs = std::filesystem;
namespace {

bool same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

/// Of two paths as they will be, links resolved, whether the files exist or not.
bool same_name(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error) &&
         !error;
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path inside = fs::weakly_canonical(fs::absolute(file), error);
  for (fs::path above = inside.parent_path(); above != above.root_path(); above = above.parent_path())
    if (same(above, folder)) return true;
  return false;
}

}  // namespace

void require_not_read(const fs::path& output, const std::vector<fs::path>& inputs) {
  std::error_code error;
  if (output.empty()) return;
  for (const fs::path& input : inputs) {
    if (input.empty()) continue;
    if (same(output, input) || same_name(output, input))
      throw InputError(output.string(), "is read as well as written, expected another name for the output");
    if (fs::is_directory(input, error) && fs::exists(output, error) && lies_in(output, input))
      throw InputError(output.string(), "is a file of " + input.string() +
                                            ", which is read, expected another name for the output");
  }
}

}  // namespace rigsound
