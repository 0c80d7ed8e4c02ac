// rigsound studio: a web page on this machine, where recordings become a sound set.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "endings.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/file/read_files.hpp"
#include "standard_output.hpp"
#include "studio/server/studio.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct StudioArguments {
  std::string sound_set, recordings, rig, page, pages;
  studio::StudioOptions options;
};

studio::StudioOptions studio_options(const StudioArguments& a) {
  studio::StudioOptions options = a.options;
  options.sound_set = a.sound_set;
  options.recordings = a.recordings;
  options.rig = a.rig;
  options.pages = a.pages;
  options.cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.version = RIGSOUND_VERSION;
  return options;
}

void export_to(const StudioArguments& a) {
  require_file("--export", a.page);
  require_ending("--export", a.page, {".html", ".htm"});
  require_apart({a.page}, {a.rig});
  require_apart({a.page}, config::content_of(a.sound_set));
  studio::export_page(studio_options(a), a.page);
}

void serve(const StudioArguments& a) {
  studio::Studio studio(studio_options(a));
  fmt::print("{}\n", studio.address());
  std::fflush(stdout);
  studio.serve();
}

}  // namespace

void add_studio(cli::Verb& program) {
  cli::Verb verb =
      program.verb("studio", "Open recordings and a sound set as a page in a browser").group(kPrepare);
  auto a = std::make_shared<StudioArguments>();
  verb.positional("SOUNDSET", a->sound_set, "folder of the sound set; the first analysis makes it")
      .required();
  verb.option("--recordings", a->recordings,
              "folder of recordings, their label tracks and bus logs (not the folders inside)");
  verb.option("--rig", a->rig, "rig that is heard on the page, and whose buses the logs are of")
      .type("RIG.toml");
  verb.option("--daemon", a->options.daemon, "control socket of a running rigsoundd").type("SOCKET");
  verb.option("--port", a->options.port, "to listen at, on this machine only; 0: any that is free")
      .range(0, 65535)
      .shows_default();
  verb.option("--export", a->page,
              "write the rig's page with its sounds inside, one file that opens without a server, and end")
      .type("PAGE.html");
  verb.option("--pages", a->pages, "folder of the page, where it is neither installed nor built");
  verb.details(
      "Prints the address, which holds a secret word, and serves until it is stopped with Ctrl-C. No other "
      "machine can reach it, and no other page. Label tracks, refinements and tools are written beside what "
      "they belong to; the last version is kept.");
  verb.example("rigsound studio out/soundset --recordings recordings --rig config/rigs/demo.toml");
  verb.example("rigsound studio out/soundset --rig config/rigs/demo.toml --export demo.html");
  verb.callback([a] { a->page.empty() ? serve(*a) : export_to(*a); });
}

}  // namespace rigsound::tools
