#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "analyzer/finished_bank.hpp"
#include "analyzer/part_analysis.hpp"
#include "analyzer/part_list.hpp"
#include "analyzer/run_lock.hpp"
#include "analyzer/set_laws.hpp"
#include "analyzer/source_hash.hpp"
#include "bank/lint.hpp"
#include "report/bank_page.hpp"
#include "report/report_section.hpp"
#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/parallel.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/read_files.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

struct Task {
  Part part;
  std::shared_ptr<SourceHash> source;
  std::optional<AnalysedPart> done;
  std::string failure;
  std::vector<std::string> notes;
};

std::vector<Task> tasks_of(const std::vector<Part>& parts, const AnalyzerOptions& options) {
  std::vector<Part> ours;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (static_cast<int>(i + 1) % options.shards == options.shard % options.shards) ours.push_back(parts[i]);
  std::map<fs::path, std::shared_ptr<SourceHash>> hashes;
  std::vector<Task> tasks;
  for (const Part& part : ours) {
    std::shared_ptr<SourceHash>& hash = hashes[part.recording];
    if (!hash) hash = std::make_shared<SourceHash>(part.recording);
    tasks.push_back({part, hash, std::nullopt, {}, {}});
  }
  return tasks;
}

AnalysedPart analyse(Task& task, const std::string& sha256, const AnalyzerOptions& options) {
  SampleFile file;
  const LongRecording recording = read_part(task.part, file);
  task.notes = reading_notes(task.part.recording, recording);
  const PartAnalysis analysis = analyse_part(task.part, recording.mono, file, options);
  const std::string where = stretches_text(analysis.chain.joined.verdict);
  if (!task.part.labelled && !where.empty())
    task.notes.push_back(fmt::format("{}: {}", task.part.recording.string(), where));
  const ClickBank& bank = analysis.built.bank;
  AnalysedPart analysed{
      task.part, false, bank.mean_gap_samples, static_cast<int>(bank.clicks.size()), analysis.built.figures,
      {}};
  std::string page;
  if (options.report == ReportSections::kWrite)
    page =
        bank_page(analysed, report_section({analysis.recorded, analysis.start_s,
                                            analysis.chain.joined.verdict, analysis.chain.drilling, bank}));
  const std::string replaced = save_part(analysed, bank, sha256, page, options);
  if (!replaced.empty()) task.notes.push_back(replaced);
  return analysed;
}

void run_task(Task& task, const AnalyzerOptions& options) {
  try {
    const std::string sha256 = task.source->sha256();
    task.done = finished_part(task.part, sha256, options);
    if (!task.done) task.done = analyse(task, sha256, options);
    task.done->warnings = lint_bank(*task.done, options.clicks);
  } catch (const DeviceError&) {
    throw;
  } catch (const InputError& error) {
    task.failure = error.what();
  } catch (const std::exception& error) {
    task.failure = task.part.recording.string() + ": cannot be analysed: " + error.what();
  }
}

/// Counts analysed parts and tells the caller, one thread at a time.
class Announcer {
 public:
  Announcer(const AnalyzerListener& listener, int total) : listener_(listener), total_(total) {}
  void add(const Task& task) {
    const std::lock_guard<std::mutex> lock(mutex_);
    task.done&& task.done->kept ? --total_ : ++analysed_;
    if (task.done && listener_.done) listener_.done(*task.done);
    if (listener_.progress) listener_.progress(analysed_, total_);
  }

 private:
  const AnalyzerListener& listener_;
  std::mutex mutex_;
  int analysed_ = 0, total_;
};

void merge(const std::vector<AnalysedPart>& banks, const AnalyzerOptions& options,
           std::vector<std::string>& notes) {
  const fs::path& sound_set = options.sound_set;
  config::SoundSetIndex additions;
  for (const AnalysedPart& b : banks) {
    const Label& label = b.part.label;
    config::BankEntry entry;
    entry.name = b.part.bank, entry.situation = label.situation, entry.rods = label.rods,
    entry.rock = label.rock, entry.feed_bar = label.feed_bar, entry.percussion_bar = label.percussion_bar;
    additions.banks.push_back(entry);
    if (!label.rock.empty()) additions.rocks.push_back({label.rock});  // one named twice is added once
  }
  FileLock lock(sound_set / ".index.lock");
  lock.wait_exclusive();
  config::merge_index(sound_set, additions);
  if (options.shards > 1) return;  // a later run over all parts keeps their banks and sees every series whole
  add_laws(sound_set, (sound_set / "soundset.toml").string(), notes);
}

}  // namespace

AnalyzerResult run_analyzer(const AnalyzerOptions& options, const AnalyzerListener& listener) {
  PartList list = list_parts(options);
  require_apart({options.page}, list.read);
  require_apart({options.page}, config::content_of(options.sound_set));
  require_outside(options.sound_set / "banks", list.read);
  std::error_code error;
  // A broken index is reported now and not after hours of work.
  if (fs::exists(options.sound_set / "soundset.toml", error)) config::load_index(options.sound_set);
  const RunLock running(options.sound_set);

  std::vector<Task> tasks = tasks_of(list.parts, options);
  Announcer announcer(listener, static_cast<int>(tasks.size()));
  for_each_index(static_cast<int>(tasks.size()), options.jobs, [&](int i) {
    run_task(tasks[i], options);
    announcer.add(tasks[i]);
  });

  AnalyzerResult result;
  result.failures = std::move(list.failures);
  result.notes = std::move(list.notes);
  std::set<std::string> said(result.failures.begin(), result.failures.end());
  for (Task& task : tasks) {
    for (std::string& note : task.notes)
      if (said.insert(note).second) result.notes.push_back(std::move(note));
    if (task.done)
      result.banks.push_back(std::move(*task.done));
    else if (said.insert(task.failure).second)
      result.failures.push_back(task.failure);
  }
  lint_series(result.banks);
  if (!result.banks.empty()) merge(result.banks, options, result.notes);
  return result;
}

}  // namespace rigsound::analysis
