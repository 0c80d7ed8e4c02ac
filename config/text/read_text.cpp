#include "text/read_text.hpp"

#include "rigsound/file/input_file.hpp"

namespace rigsound::config {

std::string read_text(const std::filesystem::path& file) { return InputFile(file, "file").content(); }

}  // namespace rigsound::config
