#include "analyzer/part_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "analyzer/bus_parts.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> recordings_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_recording_name(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> recordings_of(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> files;
  for (const fs::path& input : inputs) {
    std::error_code none;
    if (!fs::is_directory(input, none)) {
      if (input == "-" || (fs::exists(input, none) && fs::is_other(input, none)))
        throw InputError(input.string(), "is a pipe, expected a file: its parts are read one by one");
      files.push_back(input);
      continue;
    }
    const std::vector<fs::path> inside = recordings_in(input);
    if (inside.empty())
      throw InputError(input.string(), "holds no recordings, expected WAV, FLAC or the like");
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

std::string as_name(const std::string& text) {
  std::string name = text;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-' && c != '.') c = '_';
  return name.empty() || name[0] == '.' ? "_" + name : name;
}

/// STEM, or FOLDER_STEM where another recording of the list has the same stem.
std::map<fs::path, std::string> stems_of(const std::vector<fs::path>& recordings) {
  std::map<std::string, std::set<fs::path>> sharing;
  for (const fs::path& file : recordings) sharing[as_name(file.stem().string())].insert(file);
  std::map<fs::path, std::string> stems;
  for (const auto& [stem, files] : sharing)
    for (const fs::path& file : files) {
      const std::string folder = fs::absolute(file).parent_path().filename().string();
      stems[file] = files.size() == 1 ? stem : as_name(folder) + "_" + stem;
    }
  return stems;
}

std::string labelled_name(const std::string& stem, const Label& label) {
  return fmt::format("{}_{:05}ms", stem, std::llround(label.start_s * 1000));
}

/// The same sound in two banks may be meant, but is more often a mistake.
void note_overlaps(const std::vector<Part>& parts, std::vector<std::string>& notes) {
  for (std::size_t b = 1; b < parts.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const Label &first = parts[a].label, &second = parts[b].label;
      const double common = std::min(first.end_s, second.end_s) - std::max(first.start_s, second.start_s);
      if (common > kLabelSlack_s)
        notes.push_back(
            fmt::format("{}:{}: start: overlaps the label of line {} by {:.3f} s, both are analysed",
                        parts[b].labels.string(), second.line, first.line, common));
    }
}

/// What says which stretch of a recording is what.
struct Labelling {
  fs::path file;  ///< labels or bus log; empty: neither, the recording is taken whole
  std::vector<Label> labels;
};

/// What bus logs are read with.
struct BusReading {
  config::Rig rig;
  std::vector<std::string> rocks;  ///< names of the bus's rock numbers
};

/// The rocks are those of the sound set that is filled, else of the one the rig plays.
std::optional<BusReading> bus_reading(const AnalyzerOptions& options) {
  if (options.rig.empty()) return std::nullopt;
  BusReading reading{config::load_rig(options.rig), {}};
  std::error_code none;
  for (const fs::path& set : {options.sound_set, reading.rig.sound_set}) {
    if (!reading.rocks.empty() || !fs::exists(set / "soundset.toml", none)) continue;
    for (const config::RockEntry& rock : config::load_index(set).rocks) reading.rocks.push_back(rock.name);
  }
  return reading;
}

Labelling by_bus(const fs::path& recording, const fs::path& log, const BusReading& bus, double offset_s,
                 std::vector<std::string>& notes) {
  const BusParts parts =
      bus_parts(read_bus_course(bus.rig, log), offset_s, recording_seconds(recording), bus.rocks);
  for (const std::string& note : parts.notes) notes.push_back(log.string() + ": " + note);
  if (parts.labels.empty())
    throw InputError(log.string(),
                     "has no drilling within the recording, expected feed and hammer on while " +
                         recording.string() + " was recorded");
  return {log, parts.labels};
}

/// The file that says which stretch is what; empty: there is none.
struct SaidBy {
  fs::path file;
  bool bus_log = false;
};

/// A file given for the one recording, else the one beside it; a bus log before labels.
SaidBy said_by(const fs::path& recording, const AnalyzerOptions& options, bool with_bus) {
  const auto beside = [&recording](const char* extension) {
    const fs::path file = fs::path(recording).replace_extension(extension);
    std::error_code none;
    return fs::exists(file, none) ? file : fs::path();
  };
  if (!options.labels.empty()) return {options.labels};
  const fs::path log = options.bus_log.empty() ? beside(".log") : options.bus_log;
  if (with_bus && !log.empty()) return {log, true};
  return {beside(".txt")};
}

Labelling labelling_of(const fs::path& recording, const SaidBy& by, const AnalyzerOptions& options,
                       const std::optional<BusReading>& bus, std::vector<std::string>& notes) {
  if (by.bus_log) return by_bus(recording, by.file, *bus, options.bus_log_offset_s, notes);
  if (!by.file.empty()) return {by.file, read_labels(by.file)};
  Label whole;
  whole.situation = options.situation.value_or(Situation::kNormal);
  return {{}, {whole}};
}

void add_labelled(const fs::path& recording, const std::string& stem, const Labelling& labelling,
                  PartList& list) {
  std::vector<Part> parts;
  std::set<std::string> names;
  for (const Label& label : labelling.labels) {
    parts.push_back({recording, labelled_name(stem, label), labelling.file, label});
    if (!names.insert(parts.back().bank).second)
      throw InputError(
          labelling.file.string(), label.line, "start",
          fmt::format("another label starts at {} s too, expected one bank a start", label.start_s));
  }
  note_overlaps(parts, list.notes);
  list.parts.insert(list.parts.end(), parts.begin(), parts.end());
}

/// A file that goes with one recording is not for several.
void require_one(const fs::path& file, const char* kind, const char* extension, std::size_t recordings) {
  if (!file.empty() && recordings != 1)
    throw InputError(file.string(),
                     fmt::format("is given for {} recordings, expected one (a {} beside each recording, with "
                                 "its name and {}, is found by itself)",
                                 recordings, kind, extension));
}

}  // namespace

PartList list_parts(const AnalyzerOptions& options) {
  const std::vector<fs::path> recordings = recordings_of(options.inputs);
  require_one(options.labels, "label file", ".txt", recordings.size());
  require_one(options.bus_log, "bus log", ".log", recordings.size());
  const std::map<fs::path, std::string> stems = stems_of(recordings);
  const std::optional<BusReading> bus = bus_reading(options);
  PartList list;
  list.read = recordings;
  if (bus) {
    list.read.push_back(bus->rig.file);
    list.read.insert(list.read.end(), bus->rig.dbc_files.begin(), bus->rig.dbc_files.end());
  }
  std::set<std::string> taken;
  for (const fs::path& recording : recordings) {
    const std::string& stem = stems.at(recording);
    if (!taken.insert(stem).second) {
      list.failures.push_back(recording.string() +
                              ": its bank would be named like another's, expected other file names");
      continue;
    }
    try {
      const SaidBy by = said_by(recording, options, bus.has_value());
      list.read.push_back(by.file);
      const Labelling labelling = labelling_of(recording, by, options, bus, list.notes);
      if (labelling.file.empty())
        list.parts.push_back({recording, stem, {}, labelling.labels.front(), options.situation.has_value()});
      else
        add_labelled(recording, stem, labelling, list);
    } catch (const InputError& error) {
      list.failures.push_back(error.what());
    }
  }
  return list;
}

}  // namespace rigsound::analysis
