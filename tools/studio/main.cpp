// `rigsound-studio`: what `rigsound studio` goes on as.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "command.hpp"
#include "endings.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/file/read_files.hpp"
#include "standard_output.hpp"
#include "studio/server/studio.hpp"
#include "studio/studio_words.hpp"

using namespace rigsound;

namespace {

studio::StudioOptions studio_options(const studio::StudioWords& a) {
  studio::StudioOptions options = a.options;
  options.sound_set = a.sound_set;
  options.recordings = a.recordings;
  options.rig = a.rig;
  options.pages = a.pages;
  options.cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.version = RIGSOUND_VERSION;
  return options;
}

void export_to(const studio::StudioWords& a) {
  tools::require_file("--export", a.page);
  tools::require_ending("--export", a.page, {".html", ".htm"});
  require_apart({a.page}, {a.rig});
  require_apart({a.page}, config::content_of(a.sound_set));
  studio::export_page(studio_options(a), a.page);
}

void serve(const studio::StudioWords& a) {
  studio::Studio studio(studio_options(a));
  fmt::print("{}\n", studio.address());
  std::fflush(stdout);
  studio.serve();
}

void add_studio(cli::Verb& program) {
  studio::add_studio_words(program,
                           [](const studio::StudioWords& a) { a.page.empty() ? serve(a) : export_to(a); });
}

}  // namespace

/// Also without the verb's name, which stands in the command line of who goes on as this program.
int main(int argc, char** argv) {
  std::vector<char*> words(argv, argv + argc);
  std::string verb = "studio";
  if (words.size() < 2 || words[1] != verb) words.insert(words.begin() + 1, verb.data());
  constexpr tools::AddVerb kVerbs[] = {add_studio};
  return tools::run_command(kVerbs, kVerbs + 1, static_cast<int>(words.size()), words.data());
}
