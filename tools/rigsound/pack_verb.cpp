// rigsound pack, rigsound unpack: a sound set as one file, and back.
#include <fmt/format.h>

#include <memory>

#include "figure_row.hpp"
#include "progress_bar.hpp"
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
  bool json = false;
};

/// One line that begins with the output's name alone, or a document.
void print_packed(const PackOptions& o, const FigureRow& figures) {
  std::FILE* const to = figures_beside({o.out});
  if (!o.json) return fmt::print(to, "{} {}\n", o.out, figures.words());
  Json json{{"out", o.out}};
  json.update(figures.json());
  print_document(json, to);
}

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
  ProgressBar bar;
  set.parts = config::load_parts(o.sound_set, [&](double share) { bar.show(share); });
  if (!o.rig.empty()) set.rig = packed_rig(o.rig, o.sound_set, set.parts, o.out);
  const std::string bytes = config::packed(set);
  write_file(o.out, bytes);
  bar.clear();
  FigureRow figures;
  print_packed(o, figures.add_count("banks", set.parts.banks.size())
                      .add_count("tools", set.parts.tools.size() + set.parts.strings.size())
                      .add_count("backgrounds", set.parts.diesels.size())
                      .add_flag("rig", set.rig.has_value())
                      .add_count("bytes", bytes.size()));
}

void unpack(const PackOptions& o) {
  const config::PackedSet set = config::load_packed(o.sound_set);
  ProgressBar bar;
  config::save_parts(o.out, set.parts, [&](double share) { bar.show(share); });
  bar.clear();
  FigureRow figures;
  print_packed(o, figures.add_count("banks", set.parts.banks.size()));
}

}  // namespace

void add_pack(cli::Verb& program) {
  cli::Verb verb = program.verb("pack", "Put a sound set into one file").group(kPrepare);
  auto o = std::make_shared<PackOptions>();
  verb.positional("SOUNDSET", o->sound_set, "folder of the sound set").required();
  verb.positional("OUT.rigset", o->out, "file to write").required();
  verb.option("--rig", o->rig,
              "rig whose engine options are packed too, so that it plays without a rig file");
  verb.flag("--json", o->json, "the figures as one JSON document");
  verb.details(
      "A rig's `set` takes the file as it takes a folder. It is checked by its SHA-256 when it is read, and "
      "holds all of "
      "the set: `unpack` gives a folder that sounds the same, bit for bit.");
  verb.example("rigsound pack out/soundset demo.rigset --rig config/rigs/demo.toml");
  verb.example("rigsound pack out/soundset demo.rigset --json");
  verb.callback([o] { pack(*o); });
}

void add_unpack(cli::Verb& program) {
  cli::Verb verb = program.verb("unpack", "Make a folder of a packed sound set").group(kPrepare);
  auto o = std::make_shared<PackOptions>();
  verb.positional("IN.rigset", o->sound_set, "what pack wrote").required();
  verb.positional("SOUNDSET", o->out, "folder to make; it must not be there yet").required();
  verb.flag("--json", o->json, "the figures as one JSON document");
  verb.example("rigsound unpack packed.rigset soundset --json");
  verb.example("rigsound unpack demo.rigset soundset");
  verb.callback([o] { unpack(*o); });
}

}  // namespace rigsound::tools
