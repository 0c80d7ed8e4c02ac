#include "text/read_text.hpp"

#include <fstream>
#include <iterator>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string(), "is a folder, expected a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), "cannot be opened, expected a readable file");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InputError(file.string(), "cannot be read to its end");
  return text;
}

}  // namespace rigsound::config
