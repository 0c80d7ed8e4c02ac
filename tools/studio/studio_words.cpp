#include "studio/studio_words.hpp"

#include <memory>
#include <utility>

#include "verbs.hpp"

namespace rigsound::studio {

void add_studio_words(cli::Verb& program, std::function<void(const StudioWords&)> run) {
  cli::Verb verb =
      program.verb("studio", "Open recordings and a sound set as a page in a browser").group(tools::kPrepare);
  auto a = std::make_shared<StudioWords>();
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
  verb.callback([a, run = std::move(run)] { run(*a); });
}

}  // namespace rigsound::studio
