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

/// A file of the folder by another name.
bool linked_in(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  if (fs::hard_link_count(file, error) < 2 || error) return false;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
    if (same(file, entry.path())) return true;
  return false;
}

/// Neither has content that writing could replace.
bool passes_by(const fs::path& path) {
  std::error_code error;
  return path.empty() || path == "-" || (fs::exists(path, error) && fs::is_other(path, error));
}

void require_not_read(const fs::path& output, const std::vector<fs::path>& inputs) {
  std::error_code error;
  for (const fs::path& input : inputs) {
    if (passes_by(input)) continue;
    if (same(output, input) || same_name(output, input))
      throw InputError(output.string(), "is read as well as written, expected another name for the output");
    if (fs::is_directory(input, error) && fs::exists(output, error) &&
        (lies_in(output, input) || linked_in(output, input)))
      throw InputError(output.string(), "is a file of " + input.string() +
                                            ", which is read, expected another name for the output");
  }
}

}  // namespace

void require_apart(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (passes_by(*output)) continue;
    require_not_read(*output, inputs);
    for (auto other = outputs.begin(); other != output; ++other)
      if (!passes_by(*other) && (same(*output, *other) || same_name(*output, *other)))
        throw InputError(output->string(), "is written twice, expected another name for one of them");
  }
}

void require_outside(const fs::path& folder, const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs)
    if (!passes_by(input) && lies_in(input, folder))
      throw InputError(input.string(), "lies in " + folder.string() +
                                           ", which is written anew, expected it in another folder");
}

}  // namespace rigsound
