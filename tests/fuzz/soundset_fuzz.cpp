// Any text as a soundset.toml: read or refused; names in it leave no folder.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "fuzz_target.hpp"
#include "memory_file.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;

namespace {

std::filesystem::path new_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "rigsound_fuzz.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) std::abort();
  static const std::string kept = name;
  std::atexit([] { std::filesystem::remove_all(kept); });
  return name;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path folder = new_folder();
  std::ofstream(folder / "soundset.toml", std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  config::SoundSetIndex index;
  if (!fuzz::accepts<InputError>([&] { index = config::load_index(folder); })) return 0;
  for (const config::BankEntry& bank : index.banks)
    if (bank.name.find('/') != std::string::npos || bank.name[0] == '.') std::abort();
  return 0;
}
