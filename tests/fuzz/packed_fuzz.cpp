// Any bytes as a packed sound set, their hash made right: read or refused with a message.
#include <cstring>
#include <string>

#include "fuzz_target.hpp"
#include "rigsound/config/packed_set.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/pack/sha256.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHashAt = 24, kHashed = 56;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (size > kHashed) {
    const std::uint64_t whole = size;
    std::memcpy(bytes.data() + 16, &whole, sizeof whole);
    const auto hash = config::sha256(std::string_view(bytes).substr(kHashed));
    std::memcpy(bytes.data() + kHashAt, hash.data(), hash.size());
  }
  try {
    config::sound_set_of(config::read_packed(bytes, "fuzz.rigset").parts, 48000);
  } catch (const InputError&) {
  }
  return 0;
}
