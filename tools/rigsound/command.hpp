// What the program of a verb does around it: streams, signals, exit codes. Thread: OFF.
#pragma once

#include "verbs.hpp"

namespace rigsound::tools {

/// `rigsound` with the verbs first ... last, as its main(). 0 done, 1 wrong input, 2 wrong usage, 3 machine
/// failed.
int run_command(const AddVerb* first, const AddVerb* last, int argc, char** argv);

}  // namespace rigsound::tools
