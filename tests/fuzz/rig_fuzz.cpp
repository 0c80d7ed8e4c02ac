// Any bytes as a rig file: read, or refused with one line.
#include <cstdlib>
#include <cstring>

#include "fuzz_target.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    config::parse_rig({reinterpret_cast<const char*>(data), size}, RIGSOUND_CONFIG "/rigs/fuzz.toml");
  } catch (const InputError& error) {
    if (std::strlen(error.what()) == 0) std::abort();
  }
  return 0;
}
