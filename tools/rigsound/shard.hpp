// Which share of a batch a run does. Thread: OFF.
#pragma once

#include <string>

namespace rigsound::tools {

/// Every `count`-th part, beginning with the `number`-th; 1 <= number <= count.
struct Shard {
  int number = 1, count = 1;
};

/// "I/N", or "auto": the task of a Slurm array, whose numbers may begin anywhere and go in equal steps
/// (SLURM_ARRAY_TASK_ID, _MIN, _MAX, _COUNT, _STEP). Errors: cli::UsageError; also for an array of which a
/// number is left out, because nobody would do its share.
Shard read_shard(const std::string& text);

}  // namespace rigsound::tools
