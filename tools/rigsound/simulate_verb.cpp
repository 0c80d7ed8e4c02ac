// rigsound simulate: recordings with their truth.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "figure_row.hpp"
#include "progress_bar.hpp"
#include "rigsound/analysis/simulate.hpp"
#include "rigsound/file/atomic_folder.hpp"
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
  double ramp_seconds = 0;
  std::string rods;
  bool json = false;
};

constexpr double kRecordingSeconds = 18, kClipSeconds = 2;
constexpr int kMostRods = 20;

/// "7" and "100-131" into numbers.
std::vector<int> expand(const std::string& option, const std::vector<std::string>& ranges) {
  std::vector<int> ids;
  for (const std::string& text : ranges) {
    int low = 0, high = 0, read = 0;
    const int found = std::sscanf(text.c_str(), "%d%n-%d%n", &low, &read, &high, &read);
    if (found < 1 || read != static_cast<int>(text.size()))
      throw cli::UsageError(option, "'" + text + "' is neither a number nor a range such as 3-7");
    for (int id = low; id <= (found == 2 ? high : low); ++id) ids.push_back(id);
  }
  return ids;
}

/// "1,3,6" into rod counts.
std::vector<int> rod_counts(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) c == ',' ? words.emplace_back().clear() : words.back().push_back(c);
  std::vector<int> counts = expand("--rods", words);
  for (const int count : counts)
    if (count < 1 || count > kMostRods)
      throw cli::UsageError("--rods", fmt::format("is {}, expected 1...{}", count, kMostRods));
  return counts;
}

/// Each part takes about as long as it sounds: seven recordings, three a rod count, the ramp.
std::vector<std::string> situations(const SimulateOptions& o, const std::filesystem::path& folder,
                                    const Progress& progress) {
  const double seconds = o.seconds > 0 ? o.seconds : kRecordingSeconds;
  const std::vector<int> counts = o.rods.empty() ? std::vector<int>() : rod_counts(o.rods);
  const double main_s = 7 * seconds, rods_s = 3 * seconds * static_cast<double>(counts.size()),
               all_s = main_s + rods_s + o.ramp_seconds;
  std::vector<std::string> lines =
      analysis::write_situations(folder, o.seed, seconds, part_of(progress, 0, main_s / all_s));
  const auto add = [&lines](const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  if (!counts.empty())
    add(analysis::write_rods(folder, o.seed, counts, seconds,
                             part_of(progress, main_s / all_s, (main_s + rods_s) / all_s)));
  if (o.ramp_seconds > 0) add(analysis::write_feed_ramp(folder, o.seed, o.ramp_seconds));
  return lines;
}

/// A number, LOW..HIGH as two of them, or the word itself.
Json figure(const std::string& word) {
  const std::size_t dots = word.find("..");
  if (dots != std::string::npos) return {figure(word.substr(0, dots)), figure(word.substr(dots + 2))};
  const Json number = config::parsed_json(word);
  return number.is_number() ? number : Json(word);
}

/// Of lines `FILE name=value name=value`.
Json recordings(const std::vector<std::string>& lines) {
  Json list = Json::array();
  for (const std::string& line : lines) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    Json recording{{"recording", word}};
    while (words >> word) recording[word.substr(0, word.find('='))] = figure(word.substr(word.find('=') + 1));
    list.push_back(std::move(recording));
  }
  return list;
}

void simulate(const SimulateOptions& o) {
  AtomicFolder folder(o.folder);  // all recordings or none
  ProgressBar bar;
  const auto progress = [&bar](double share) { bar.show(share); };
  const std::vector<std::string> lines =
      o.ids.empty() ? situations(o, folder.temporary(), progress)
                    : analysis::write_drillbench(folder.temporary(),
                                                 {expand("--ids", o.ids), o.snr_db,
                                                  o.seconds > 0 ? o.seconds : kClipSeconds, o.rate_factor},
                                                 progress);
  bar.clear();
  folder.join();
  if (o.json) return print_document({{"recordings", recordings(lines)}});
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
      .range(1, 3600, "s");
  const cli::Option ids =
      verb.option("--ids", o->ids, "DrillBench clips by number instead, such as 100-131 or 3,7")
          .separated_by_commas();
  verb.option("--feed-ramp", o->ramp_seconds,
              "also a recording of so many seconds along a feed ramp, with its bus log; the name alone: 120")
      .range(10, 3600, "s")
      .value_or("120")
      .excludes(ids);
  verb.option("--rods", o->rods,
              "also underfeed, normal and overfeed of these rod counts; the name alone: 1,3,6")
      .value_or("1,3,6")
      .type("N,N...")
      .excludes(ids);
  verb.option("--snr", o->snr_db, "ratios of the mixed clips, dB").separated_by_commas().needs(ids);
  verb.option("--rate-factor", o->rate_factor, "the same impacts, this much closer together")
      .range(0.25, 4)
      .needs(ids);
  verb.example("rigsound simulate --out recordings --seed 7");
  verb.example("rigsound simulate --out recordings --feed-ramp --rods 1,3,6");
  verb.flag("--json", o->json, "the recordings and their truth in figures as one JSON document");
  verb.example("rigsound simulate --out recordings --json");
  verb.example("rigsound simulate --out bench --ids 100-131 --snr -6,0,6,12");
  verb.callback([o] { simulate(*o); });
}

}  // namespace rigsound::tools
