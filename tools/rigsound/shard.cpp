#include "shard.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "cli/number_text.hpp"
#include "cli/verb.hpp"

namespace rigsound::tools {
namespace {

constexpr const char* kShardOption = "--shard";

[[noreturn]] void refuse_shard(const std::string& what) { throw cli::UsageError(kShardOption, what); }

/// A number that Slurm gives every task of an array.
int slurm_number(const char* name, const char* absent) {
  const char* const text = std::getenv(name);
  const std::string word = text != nullptr ? text : absent;
  if (word.empty())
    refuse_shard(
        fmt::format("auto: {} is not set, expected a task of a Slurm array (sbatch --array), or I/N", name));
  if (!cli::int32_fault(word).empty() || cli::integer_of(word) < 0)
    refuse_shard(fmt::format("auto: {} is '{}', expected a whole number from 0 on", name, word));
  return static_cast<int>(cli::integer_of(word));
}

Shard shard_of_slurm_array() {
  const int id = slurm_number("SLURM_ARRAY_TASK_ID", ""), first = slurm_number("SLURM_ARRAY_TASK_MIN", ""),
            last = slurm_number("SLURM_ARRAY_TASK_MAX", ""),
            count = slurm_number("SLURM_ARRAY_TASK_COUNT", ""),
            step = slurm_number("SLURM_ARRAY_TASK_STEP", "1");
  const bool even =
      step > 0 && last >= first && (last - first) % step == 0 && (last - first) / step + 1 == count;
  if (!even || id < first || id > last || (id - first) % step != 0)
    refuse_shard(fmt::format(
        "auto: task {} of {} from {} to {} leaves numbers out, expected an array such as 0-3, 1-4 or 0-6:2",
        id, count, first, last));
  return {(id - first) / step + 1, count};
}

}  // namespace

Shard read_shard(const std::string& text) {
  if (text == "auto") return shard_of_slurm_array();
  Shard shard;
  int read = 0;
  if (std::sscanf(text.c_str(), "%d/%d%n", &shard.number, &shard.count, &read) != 2 ||
      read != static_cast<int>(text.size()) || shard.number < 1 || shard.number > shard.count)
    refuse_shard("'" + text + "' is wrong, expected I/N with I from 1 to N, or auto");
  return shard;
}

}  // namespace rigsound::tools
