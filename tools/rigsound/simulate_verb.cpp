// rigsound simulate: recordings with their truth.
#include <cstdio>
#include <memory>

#include "rigsound/analysis/simulate.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct SimulateOptions {
  std::string folder;
  std::uint64_t seed = 1;
  double seconds = 0;
  std::vector<std::string> ids;
  std::vector<std::string> snr_db{"-6", "0", "6", "12"};
  double rate_factor = 1;
};

constexpr double kRecordingSeconds = 18, kClipSeconds = 2;

/// "7" and "100-131" into numbers.
std::vector<int> expand(const std::vector<std::string>& ranges) {
  std::vector<int> ids;
  for (const std::string& text : ranges) {
    int low = 0, high = 0, read = 0;
    const int found = std::sscanf(text.c_str(), "%d%n-%d%n", &low, &read, &high, &read);
    if (found < 1 || read != static_cast<int>(text.size()))
      throw cli::UsageError("--ids", "'" + text + "' is neither a number nor a range such as 100-131");
    for (int id = low; id <= (found == 2 ? high : low); ++id) ids.push_back(id);
  }
  return ids;
}

void simulate(const SimulateOptions& o) {
  std::vector<std::string> lines;
  if (o.ids.empty()) {
    lines = analysis::write_situations(o.folder, o.seed, o.seconds > 0 ? o.seconds : kRecordingSeconds);
  } else {
    lines = analysis::write_drillbench(
        o.folder, {expand(o.ids), o.snr_db, o.seconds > 0 ? o.seconds : kClipSeconds, o.rate_factor});
  }
  for (const std::string& line : lines) std::printf("%s\n", line.c_str());
}

}  // namespace

void add_simulate(cli::Verb& program) {
  cli::Verb verb =
      program.verb("simulate", "Write recordings of the five drilling situations with their exact truth")
          .group(kPrepare);
  auto o = std::make_shared<SimulateOptions>();
  verb.option("--out", o->folder, "folder for the recordings; truth/ and engine/ are made inside").required();
  verb.option("--seed", o->seed, "other seeds: other recordings of the same machine").shows_default();
  verb.option("--seconds", o->seconds, "length of a recording (default 18, of a DrillBench clip 2)")
      .range(1, 3600);
  const cli::Option ids =
      verb.option("--ids", o->ids, "DrillBench clips by number instead, such as 100-131 or 3,7")
          .separated_by_commas();
  verb.option("--snr", o->snr_db, "ratios of the mixed clips, dB").separated_by_commas().needs(ids);
  verb.option("--rate-factor", o->rate_factor, "the same impacts, this much closer together")
      .range(0.25, 4)
      .needs(ids);
  verb.example("rigsound simulate --out recordings --seed 7");
  verb.example("rigsound simulate --out bench --ids 100-131 --snr -6,0,6,12");
  verb.callback([o] { simulate(*o); });
}

}  // namespace rigsound::tools
