#include "analyzer/source_hash.hpp"

#include <fstream>
#include <vector>

#include "rigsound/config/sha256.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {

std::string file_sha256(const std::filesystem::path& path) {
  std::error_code none;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path, none))
    throw InputError(path.string(), "cannot be read, expected a recording");
  config::Sha256 hash;
  std::vector<char> buffer(1 << 16);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0)
    hash.update(buffer.data(), static_cast<std::size_t>(in.gcount()));
  return hash.hex();
}

std::string SourceHash::sha256() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sha256_.empty()) sha256_ = file_sha256(path_);
  return sha256_;
}

}  // namespace rigsound::analysis
