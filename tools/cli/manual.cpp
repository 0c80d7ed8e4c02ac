#include "cli/manual.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "cli/completion.hpp"
#include "cli/man_page.hpp"

namespace rigsound::cli {

bool write_manual(const VerbText& program, const std::string& version, const std::string& option,
                  const std::string& word) {
  if (option == "--write-completion") {
    std::fputs((word == "zsh" ? zsh_completion(program) : bash_completion(program)).c_str(), stdout);
    return true;
  }
  if (option != "--write-man-pages" || word.empty()) return false;
  const std::filesystem::path folder(word);
  std::filesystem::create_directories(folder);
  for (const Page& page : man_pages(program, version, word.substr(word.size() - 1)))
    if (!(std::ofstream(folder / page.file) << page.roff).flush())
      throw std::runtime_error((folder / page.file).string() + ": cannot be written");
  return true;
}

}  // namespace rigsound::cli
