// Apart from the rest: a browser has no files to open, and no rig files to read.
#include <fstream>
#include <utility>

#include "handle.hpp"
#include "packed_engine.hpp"
#include "rigsound/config/rig.hpp"

namespace rigsound::library {
namespace {

bool begins_packed(const std::filesystem::path& file) {
  char head[16] = {};
  std::ifstream(file, std::ios::binary).read(head, sizeof head);
  return config::is_packed({head, sizeof head});
}

Engine engine_of_file(const std::filesystem::path& file) {
  if (begins_packed(file)) return engine_of(config::load_packed(file), file);
  config::Rig rig = config::load_rig(file);
  SoundSet sounds = config::load_sounds(rig);
  return config::build_engine(rig, std::move(sounds));
}

}  // namespace
}  // namespace rigsound::library

extern "C" rigsound_handle* rigsound_open(const char* file) {
  using namespace rigsound::library;
  rigsound_handle* opened = nullptr;
  guarded(open_error(), [&] {
    require(file != nullptr, "file");
    opened = new rigsound_handle(engine_of_file(file));
  });
  return opened;
}
