#include "text/read_text.hpp"

#include <fstream>
#include <iterator>

#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {

std::string read_text(const std::filesystem::path& file) {
  const InputFile input(file, "file");
  std::ifstream in(input.path(), std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InputError(input.name(), "cannot be read to its end");
  return text;
}

}  // namespace rigsound::config
