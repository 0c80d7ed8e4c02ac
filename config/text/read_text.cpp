#include "text/read_text.hpp"

#include "rigsound/file/input_file.hpp"

namespace rigsound::config {

std::string read_text(const std::filesystem::path& file, const TextKind& kind) {
  return InputFile(file, kind.name, kind.most_bytes).content();
}

}  // namespace rigsound::config
