// Any text as a tool or a drill string: read or refused; what is read is written and read again as the same.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/tool_json.hpp"

using namespace rigsound;

namespace {

/// `rewritten`: what is written of the model read.
template <class Rewrite>
void require_stable(const std::uint8_t* data, std::size_t size, Rewrite rewritten) {
  std::string first;
  const auto read = [&] { first = rewritten(config::JsonFile(fuzz::MemoryFile(data, size).path())); };
  if (!fuzz::accepts<InputError>(read)) return;
  if (rewritten(config::JsonFile(fuzz::MemoryFile(first).path())) != first) std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  require_stable(data, size, [](const config::JsonFile& json) {
    return config::tool_json(config::read_tool_json(json));
  });
  require_stable(data, size, [](const config::JsonFile& json) {
    return config::string_json(config::read_string_json(json));
  });
  return 0;
}
