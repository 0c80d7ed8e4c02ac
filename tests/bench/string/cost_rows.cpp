// Instructions, which unlike nanoseconds do not depend on what else the machine does: this program runs
// itself under callgrind, twice as long and once, and takes the difference.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench/string/rows.hpp"
#include "bench/tool/row.hpp"
#include "engine/string/string_sounds.hpp"

namespace rigsound::bench {
namespace {

using namespace string;
using namespace tests;

constexpr int kStages = 12;       // of a rod on its way into the hole
constexpr int kChunksABlow = 38;  // 40 a second
constexpr int kShort = 76, kLong = 380;
constexpr double kSpeed_m_per_s = 0.02;

enum class Blows { kNone, kEven };
enum class Rod { kStands, kGoesDown };

struct Workload {
  const char* name;
  double length_m, diameter_m;
  int rods;
  Rod rod;
  Blows blows;
};

const std::vector<Workload> kWorkloads = {
    {"one", 3.66, 0.038, 1, Rod::kGoesDown, Blows::kEven},
    {"one-stands", 3.66, 0.038, 1, Rod::kStands, Blows::kEven},
    {"one-unstruck", 3.66, 0.038, 1, Rod::kStands, Blows::kNone},
    {"largest", 6.1, 0.051, 20, Rod::kGoesDown, Blows::kEven},
    {"largest-stands", 6.1, 0.051, 20, Rod::kStands, Blows::kEven},
    {"largest-unstruck", 6.1, 0.051, 20, Rod::kStands, Blows::kNone},
    {"most-modes", 6.4, 0.025, 20, Rod::kGoesDown, Blows::kEven},
    {"most-modes-stands", 6.4, 0.025, 20, Rod::kStands, Blows::kEven},
    {"most-modes-unstruck", 6.4, 0.025, 20, Rod::kStands, Blows::kNone},
    {"shortest", 0.6, 0.025, 20, Rod::kGoesDown, Blows::kEven},
};

int stages(const Workload& w) { return w.rod == Rod::kStands ? 1 : kStages; }

void run(const Workload& w, int chunks, dsp::LaneWidth width) {
  double sum = 0;
  for (int stage = 0; stage < stages(w); ++stage) {
    StringModel model = plain_string(w.length_m, w.diameter_m, w.rods);
    StringLayer layer(model, kStringRate, 1, 0, width);
    StringInput input;
    input.rods = w.rods;
    const double exposed_m = w.length_m * (w.rod == Rod::kStands ? 1 : 1 - (stage + 0.5) / kStages);
    for (int chunk = 0; chunk < chunks; ++chunk) {
      const bool moves = w.rod == Rod::kGoesDown;
      input.exposed_m = exposed_m - (moves ? kSpeed_m_per_s * chunk * kChunk / kStringRate : 0);
      // The first blow wakes the string in every workload.
      const bool struck = chunk == 0 || (w.blows == Blows::kEven && chunk % kChunksABlow == 5);
      const Impact blow{7.3, 1, static_cast<std::uint64_t>(chunk)};
      double out[kChunk];
      layer.process(input, {&blow, struck}, out);
      sum += out[0];
    }
  }
  if (sum == 0.123) std::puts("");  // never, but the compiler cannot know
}

/// Instructions that callgrind counts in one run, -1 if it cannot be run.
double counted(const std::string& program, const std::string& name, int chunks) {
  const std::string command = "valgrind --tool=callgrind --callgrind-out-file=/dev/null '" + program +
                              "' workload " + name + " " + std::to_string(chunks) + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) return -1;
  double count = -1;
  char line[512];
  while (std::fgets(line, sizeof line, pipe))
    if (const char* at = std::strstr(line, "Collected :")) count = std::atof(at + std::strlen("Collected :"));
  return pclose(pipe) == 0 ? count : -1;
}

class Costs {
 public:
  explicit Costs(std::string program) : program_(std::move(program)) {}

  /// Instructions per 64 frames.
  double of(const char* name, const std::string& lanes) const {
    const double difference =
        counted(program_, lanes + name, kLong) - counted(program_, lanes + name, kShort);
    for (const Workload& w : kWorkloads)
      if (std::strcmp(w.name, name) == 0) return difference / stages(w) / (kLong - kShort) * 64 / kChunk;
    return -1;
  }

  /// Of a block that a blow falls into: what blows cost, each for itself, over a block without.
  double struck(const std::string& name, const std::string& lanes) const {
    const double with = of((name + "-stands").c_str(), lanes),
                 without = of((name + "-unstruck").c_str(), lanes);
    return without + (with - without) * kChunksABlow * kChunk / 64;
  }

 private:
  std::string program_;
};

struct Limit {
  const char* name;
  const char* what;
  double average, struck;
};

void print_lanes(const Costs& costs, const Limit& limit) {
  const std::string what = limit.what;
  const double wide = costs.of(limit.name, "4:"), narrow = costs.of(limit.name, "2:");
  print({what + ", AVX2, average of a rod drilled in", Bound::kAtMost, limit.average, wide, "instructions"});
  print({what + ", AVX2, struck block, all of it out", Bound::kAtMost, limit.struck,
         costs.struck(limit.name, "4:"), "instructions"});
  print({what + ", SSE2 over AVX2", Bound::kAtMost, 2.4, narrow / wide, "times"});
}

}  // namespace

bool run_string_workload(const char* name, int chunks) {
  for (const Workload& w : kWorkloads)
    if (std::strcmp(w.name, name + 2) == 0) {
      run(w, chunks, name[0] == '4' ? dsp::LaneWidth::kFour : dsp::LaneWidth::kTwo);
      return true;
    }
  return false;
}

void print_string_cost(const char* program) {
  if (dsp::widest_lanes() != dsp::LaneWidth::kFour || counted(program, "2:one-stands", 1) < 0) {
    std::puts("SKIPPED: string_bench: instructions: no valgrind or no AVX2");
    return;
  }
  const Costs costs(program);
  print_lanes(costs, {"one", "one 3.66 m rod", 7500, 10000});
  print_lanes(costs, {"largest", "20 rods of 6.1 m x 51 mm", 15000, 17500});
  print_lanes(costs, {"most-modes", "20 rods of 6.4 m x 25 mm", 15000, 17500});
  for (const char* name : {"one-stands", "largest-stands", "most-modes-stands", "shortest"})
    std::printf("%-66s | %8.0f instructions\n", name, costs.of(name, "4:"));
}

}  // namespace rigsound::bench
