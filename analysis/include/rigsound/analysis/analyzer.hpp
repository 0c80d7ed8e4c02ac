// Section 4.2 of the drilling paper: all labelled parts of all recordings, one bank each, without anybody
// watching.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/analysis/bank_builder.hpp"
#include "rigsound/analysis/labels.hpp"
#include "rigsound/analysis/recording.hpp"

namespace rigsound::analysis {

enum class ReportSections { kSkip, kWrite };

struct AnalyzerOptions {
  std::vector<std::filesystem::path> inputs;  ///< recordings, and folders of them (not the folders inside)
  std::filesystem::path sound_set;            ///< folder the banks go to
  std::filesystem::path labels;               ///< of the one input; empty: STEM.txt beside each recording
  std::filesystem::path rig;                  ///< describes the bus of bus logs; empty: they are not read
  std::filesystem::path bus_log;  ///< of the one input; empty: STEM.log beside each recording, if it is there
  double bus_log_offset_s = 0;    ///< when in the recording the bus log begins; negative: before it
  std::optional<Situation> situation;  ///< of recordings without labels, taken whole; none: nobody has said
                                       ///< that they hold drilling, and the verdict decides
  Method method = Method::kClickNmf;
  bool denoise = true;        ///< false: recordings are taken as clean
  int machine = 1;            ///< of several in a part the one that is learned, 1 the loudest
  int clicks = 10;            ///< in a bank, at most
  int jobs = 1;               ///< parts analysed at the same time
  int shard = 1, shards = 1;  ///< this run does every shards-th part
  ReportSections report = ReportSections::kSkip;
  std::filesystem::path page;  ///< what the caller will write of the sections: must be nothing that is read
  std::string tool_version;
};

/// A stretch of one recording that becomes one bank.
struct Part {
  std::filesystem::path recording;
  std::string bank;  ///< name of its bank
  std::filesystem::path
      labels;  ///< file of its label, or the bus log; empty: the part is the whole recording
  Label label;
  bool labelled = true;  ///< a person or a bus says that it drills

  bool whole() const { return labels.empty(); }
};

struct AnalysedPart {
  Part part;
  bool kept = false;            ///< was there already, from the same sound and settings
  double mean_gap_samples = 0;  ///< samples at 48 kHz
  int clicks = 0;               ///< in the bank
  BankFigures figures;
  std::vector<std::string> warnings;
};

struct AnalyzerResult {
  std::vector<AnalysedPart> banks;    ///< in the order of inputs and labels, whatever the number of jobs
  std::vector<std::string> failures;  ///< one line each: what gave no bank, and why
  std::vector<std::string> notes;     ///< one line each: what people should know about their recordings
};

/// SHA-256 of a file's bytes, 64 hex digits: Provenance::source_sha256 of a recording. Errors: InputError
/// when it cannot be read. Thread: OFF.
std::string file_sha256(const std::filesystem::path& path);

/// The stretch of its recording that a bank was made from, of Provenance::settings; a whole recording has
/// none at its end. Thread: any.
Stretch stretch_of(const std::string& settings);

/// Called while the work goes on, from any of its threads but one at a time.
struct AnalyzerListener {
  std::function<void(const AnalysedPart& bank)> done;  ///< a bank is on disk, or was; in the order they come
  std::function<void(int analysed, int total)> progress;  ///< parts that were kept count in neither
};

/// A bus log cuts its recording into parts and wins over labels. Analyses every part that has no finished
/// bank with the same settings and source hash yet, and adds missing entries to soundset.toml. A bank is on
/// disk whole or not at all; several shards may write to one sound set at once. Errors: InputError when there
/// is nothing to analyse, soundset.toml is broken or something would be written over that is read;
/// DeviceError for the disk. A part that cannot be analysed is no error but a line of `failures`. Thread:
/// OFF; starts `jobs` threads and joins them.
AnalyzerResult run_analyzer(const AnalyzerOptions& options, const AnalyzerListener& listener);

}  // namespace rigsound::analysis
