// Apart from the reader: a browser has no files.
#include <cstdint>

#include "rigsound/config/packed_set.hpp"
#include "rigsound/file/large_block.hpp"

namespace rigsound::config {

PackedSet load_packed(const std::filesystem::path& file) {
  const LargeBlock block = read_block(file);
  const auto click_where_it_lies = [&](std::string_view bytes) {
    if (bytes.empty() || reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(float) != 0)
      return copied_click(bytes);
    const std::shared_ptr<char> part =
        block.part(static_cast<std::size_t>(bytes.data() - block.data()), bytes.size());
    return Click({part, reinterpret_cast<const float*>(part.get())}, bytes.size() / sizeof(float));
  };
  return read_packed({block.data(), block.size()}, file.string(), click_where_it_lies);
}

}  // namespace rigsound::config
