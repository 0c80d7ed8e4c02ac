// rigsound merge: sound sets that were filled apart, as one.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "progress_bar.hpp"
#include "rigsound/analysis/merge_sets.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct MergeOptions {
  std::vector<std::string> sound_sets;
  std::string out;
};

void merge(const MergeOptions& o) {
  ProgressBar bar;
  const analysis::MergedSets merged = analysis::merge_sets({o.sound_sets.begin(), o.sound_sets.end()}, o.out,
                                                           [&](double share) { bar.show(share); });
  bar.clear();
  fmt::print("{} banks={} tools={} backgrounds={} sets={}\n", o.out, merged.banks, merged.tools,
             merged.backgrounds, o.sound_sets.size());
  for (const std::string& note : merged.notes) fmt::print(stderr, "{}\n", note);
}

}  // namespace

void add_merge(cli::Verb& program) {
  cli::Verb verb =
      program.verb("merge", "Join sound sets that were filled apart, such as shards").group(kPrepare);
  auto o = std::make_shared<MergeOptions>();
  verb.positional("SOUNDSET", o->sound_sets, "folders of sound sets; they stay as they are").required();
  verb.option("--out", o->out, "sound set to make, or to add to").required();
  verb.details(
      "What two sets name alike must be the same, or nothing is written. Rocks keep the order in which they "
      "come; laws are fitted over the banks of all sets, as a run over all recordings does.");
  verb.example("rigsound merge shard1 shard2 shard3 --out soundset");
  verb.callback([o] { merge(*o); });
}

}  // namespace rigsound::tools
