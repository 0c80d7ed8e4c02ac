// How the program ends when it is told to in the midst of work. Thread: OFF.
#pragma once

namespace rigsound::tools {

/// From now on SIGINT, SIGTERM and SIGHUP end the program with 128 + the signal's number (130 on Ctrl-C), and
/// SIGPIPE as a reader that has gone ends any program: without a word. What was begun and not finished is
/// undone before. Signals that the program was started without stay ignored. A thread that blocks them keeps
/// them for itself. Once, before other threads are started.
void end_on_signals();

}  // namespace rigsound::tools
