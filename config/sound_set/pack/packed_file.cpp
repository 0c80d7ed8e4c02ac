// Apart from the reader: a browser has no files to map.
#include "rigsound/config/packed_set.hpp"
#include "rigsound/file/mapped_file.hpp"

namespace rigsound::config {

PackedSet load_packed(const std::filesystem::path& file) {
  const MappedFile mapped(file);
  return read_packed(mapped.bytes(), file.string(), [&](std::string_view part) { mapped.forget(part); });
}

}  // namespace rigsound::config
