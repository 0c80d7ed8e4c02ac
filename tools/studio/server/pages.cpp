#include "pages.hpp"

#include "folder.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::studio {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMostPageBytes = 64 << 20;

std::string type_of(const fs::path& file) {
  static const std::map<std::string, std::string> kTypes = {{".html", "text/html; charset=utf-8"},
                                                            {".js", "text/javascript; charset=utf-8"},
                                                            {".css", "text/css; charset=utf-8"},
                                                            {".wasm", "application/wasm"},
                                                            {".svg", "image/svg+xml"},
                                                            {".png", "image/png"},
                                                            {".ico", "image/x-icon"},
                                                            {".woff2", "font/woff2"},
                                                            {".json", "application/json"},
                                                            {".map", "application/json"},
                                                            {".txt", "text/plain; charset=utf-8"}};
  const auto found = kTypes.find(file.extension().string());
  return found == kTypes.end() ? "application/octet-stream" : found->second;
}

}  // namespace

Pages::Pages(const fs::path& folder) : folder_(folder) {
  std::error_code error;
  const Folder inside(folder);
  if (fs::is_directory(folder, error))
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file(error) && inside.holds(entry.path()))
        files_["/" + entry.path().lexically_relative(folder).generic_string()] = entry.path();
  const auto index = files_.find("/index.html");
  if (index == files_.end())
    throw InputError(
        folder.string(),
        "holds no index.html, expected the studio's pages (cmake --build build/release --target studio_web)");
  files_["/"] = index->second;
}

Answer Pages::answer(const Request& request) const {
  const auto found = files_.find(request.path);
  if (found == files_.end()) throw ApiError(404, "there is no such page");
  Answer answer;
  answer.type = type_of(found->second);
  answer.body = InputFile(found->second, "page", kMostPageBytes).content();
  return answer;
}

fs::path find_pages(const fs::path& wanted) {
  if (!wanted.empty()) return wanted;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/rigsound/studio";
  const fs::path built = program.parent_path() / "studio/web";
  return fs::exists(built / "index.html", error) ? built : installed;
}

}  // namespace rigsound::studio
