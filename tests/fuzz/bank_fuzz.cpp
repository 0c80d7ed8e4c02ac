// Any text as a bank.json: read or refused; what is read is written and read again as the same.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/bank_json.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto written = [](const fuzz::MemoryFile& file) {
    const config::StoredBank stored = config::read_bank_json(config::JsonFile(file.path()));
    return config::bank_json(stored.bank, stored.provenance);
  };
  std::string first;
  if (!fuzz::accepts<InputError>([&] { first = written(fuzz::MemoryFile(data, size)); })) return 0;
  if (written(fuzz::MemoryFile(first)) != first) std::abort();
  return 0;
}
