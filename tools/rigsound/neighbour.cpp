#include "neighbour.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "rigsound/device_error.hpp"

namespace rigsound::tools {
namespace fs = std::filesystem;

fs::path neighbour(const std::string& name) {
  std::error_code error;
  const fs::path own = fs::read_symlink("/proc/self/exe", error);
  fs::path path = own.parent_path() / name;
  if (!fs::exists(path, error))
    throw DeviceError(path.string() + ": is not there; install it beside " + own.filename().string());
  return path;
}

void become(const std::string& name) {
  const fs::path program = neighbour(name);
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};  // each word ends with a zero
  std::vector<char*> words;
  for (std::size_t at = 0; at < text.size(); at += std::strlen(text.data() + at) + 1)
    words.push_back(text.data() + at);
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  throw DeviceError(program.string() + ": cannot be started: " + std::strerror(errno));
}

}  // namespace rigsound::tools
