// `rigsound`: one command, many verbs. Exit codes: 0 done, 1 wrong input, 2 wrong usage, 3 machine failed.
#include <iterator>

#include "command.hpp"

using namespace rigsound;

namespace {

/// As the help lists them.
constexpr tools::AddVerb kVerbs[] = {
    tools::add_denoise,  tools::add_clicks,   tools::add_analyze,  tools::add_background, tools::add_tool,
    tools::add_simulate, tools::add_merge,    tools::add_pack,     tools::add_unpack,     tools::add_studio,
    tools::add_render,   tools::add_record,   tools::add_replay,   tools::add_ctl,        tools::add_check,
    tools::add_decode,   tools::add_timeline, tools::add_contrast, tools::add_resynth,    tools::add_bench,
};

}  // namespace

int main(int argc, char** argv) {
  return tools::run_command(std::begin(kVerbs), std::end(kVerbs), argc, argv);
}
