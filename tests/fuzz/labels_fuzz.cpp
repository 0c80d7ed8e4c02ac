// Any text as a label track: read or refused, every label a stretch of time.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/analysis/labels.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file(data, size);
  fuzz::accepts<InputError>([&] {
    for (const analysis::Label& label : analysis::read_labels(file.path()))
      if (!(label.start_s >= 0 && label.end_s > label.start_s && label.rods >= 0)) std::abort();
  });
  return 0;
}
