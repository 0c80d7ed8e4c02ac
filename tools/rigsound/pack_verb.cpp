// rigsound pack, rigsound unpack: a sound set as one file, and back.
#include <fmt/format.h>

#include <memory>

#include "rigsound/config/packed_set.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/file/read_files.hpp"
#include "standard_output.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct PackOptions {
  std::string sound_set, out, rig;
};

/// The rig's engine options, if it can play the set; `out` must be none of its files.
config::PackedRig packed_rig(const std::string& file, const std::string& sound_set,
                             const config::SoundSetParts& parts, const std::string& out) {
  config::Rig rig = config::load_rig(file);
  require_apart({out}, config::files_of(rig));
  rig.sound_set = sound_set;
  config::build_engine(rig, config::sounds_of(rig, parts));
  return {rig.engine, rig.boom_tools};
}

void pack(const PackOptions& o) {
  require_apart({o.out}, {o.rig});
  require_apart({o.out}, config::content_of(o.sound_set));
  config::PackedSet set;
  set.parts = config::load_parts(o.sound_set);
  if (!o.rig.empty()) set.rig = packed_rig(o.rig, o.sound_set, set.parts, o.out);
  const std::string bytes = config::packed(set);
  write_file(o.out, bytes);
  fmt::print(figures_beside({o.out}), "{} banks={} tools={} backgrounds={} rig={} bytes={}\n", o.out,
             set.parts.banks.size(), set.parts.tools.size() + set.parts.strings.size(),
             set.parts.diesels.size(), set.rig ? "yes" : "no", bytes.size());
}

void unpack(const PackOptions& o) {
  const config::PackedSet set = config::load_packed(o.sound_set);
  config::save_parts(o.out, set.parts);
  fmt::print("{} banks={}\n", o.out, set.parts.banks.size());
}

}  // namespace

void add_pack(cli::Verb& program) {
  cli::Verb verb = program.verb("pack", "Put a sound set into one file").group(kPrepare);
  auto o = std::make_shared<PackOptions>();
  verb.positional("SOUNDSET", o->sound_set, "folder of the sound set").required();
  verb.positional("OUT.rigset", o->out, "file to write").required();
  verb.option("--rig", o->rig,
              "rig whose engine options are packed too, so that it plays without a rig file");
  verb.details(
      "A rig's `set` takes the file as it takes a folder. It is checked by its SHA-256 when it is read, and "
      "holds all of "
      "the set: `unpack` gives a folder that sounds the same, bit for bit.");
  verb.example("rigsound pack out/soundset demo.rigset --rig config/rigs/demo.toml");
  verb.callback([o] { pack(*o); });
}

void add_unpack(cli::Verb& program) {
  cli::Verb verb = program.verb("unpack", "Make a folder of a packed sound set").group(kPrepare);
  auto o = std::make_shared<PackOptions>();
  verb.positional("IN.rigset", o->sound_set, "what pack wrote").required();
  verb.positional("SOUNDSET", o->out, "folder to make; it must not be there yet").required();
  verb.example("rigsound unpack demo.rigset soundset");
  verb.callback([o] { unpack(*o); });
}

}  // namespace rigsound::tools
