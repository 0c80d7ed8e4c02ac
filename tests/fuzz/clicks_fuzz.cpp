// Any bytes as a clicks.wav: read or refused; clicks that are read are written and read again as the same.
#include <cstdlib>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/clicks_wav.hpp"

using namespace rigsound;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int kRate = 48000;
  const fuzz::MemoryFile file(data, size);
  config::ClickStore store;
  config::Clicks clicks;
  if (!fuzz::accepts<InputError>([&] { clicks = config::read_clicks_wav(file.path(), kRate, store); }))
    return 0;
  const fuzz::MemoryFile again("");
  config::write_clicks_wav(again.path(), clicks, kRate);
  if (config::read_clicks_wav(again.path(), kRate, store) != clicks) std::abort();
  return 0;
}
