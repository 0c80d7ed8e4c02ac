// rigsound studio: a web page on this machine, where recordings become a sound set. Its program is another.
#include "neighbour.hpp"
#include "studio/studio_words.hpp"
#include "verbs.hpp"

namespace rigsound::tools {

void add_studio(cli::Verb& program) {
  studio::add_studio_words(program, [](const studio::StudioWords&) { become("rigsound-studio"); });
}

}  // namespace rigsound::tools
