#include <string_view>
#include <utility>

#include "handle.hpp"
#include "packed_engine.hpp"
#include "rigsound/config/sounding_rig.hpp"

namespace rigsound::library {

std::string& open_error() noexcept {
  thread_local std::string error;
  return error;
}

Engine engine_of(config::PackedSet set, const std::filesystem::path& file) {
  config::SoundingRig rig = config::rig_of(set, file);
  SoundSet sounds = config::sounds_of(rig, std::move(set.parts));
  return config::build_engine(rig, std::move(sounds));
}

}  // namespace rigsound::library

extern "C" rigsound_handle* rigsound_open_memory(const void* bytes, size_t size) {
  using namespace rigsound;
  constexpr const char* kName = "the packed sound set";
  rigsound_handle* opened = nullptr;
  library::guarded(library::open_error(), [&] {
    library::require(bytes != nullptr, "bytes");
    const std::string_view content(static_cast<const char*>(bytes), size);
    opened = new rigsound_handle(library::engine_of(config::read_packed(content, kName), kName));
  });
  return opened;
}
