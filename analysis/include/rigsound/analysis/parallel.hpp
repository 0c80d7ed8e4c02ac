// Independent pieces of work on several cores.
#pragma once

#include <functional>

namespace rigsound::analysis {

/// Calls work(0) … work(count - 1), each once, on up to `jobs` threads (at least 1). The order is not
/// defined: results must go to places of their own. The exception of the lowest index that threw is thrown
/// again after all are done. Thread: OFF.
void for_each_index(int count, int jobs, const std::function<void(int)>& work);

}  // namespace rigsound::analysis
