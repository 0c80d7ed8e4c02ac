// Any text as a background.json: read or refused; what is read is written, and from then on nothing changes
// (the first writing rounds).
#include <cstdlib>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/background_json.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  DieselModel model;
  const auto read = [&](const fuzz::MemoryFile& file) {
    model = config::read_background_json(config::JsonFile(file.path()));
    require_valid(model);
  };
  const fuzz::MemoryFile file(data, size);
  if (!fuzz::accepts<std::exception>([&] { read(file); })) return 0;
  const std::string first = config::background_json(model);
  read(fuzz::MemoryFile(first));
  return 0;
}
