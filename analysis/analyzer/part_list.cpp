#include "analyzer/part_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

bool is_recording(const fs::path& file) {
  static const std::set<std::string> kExtensions = {".wav", ".wave", ".w64",  ".rf64", ".flac",
                                                    ".aif", ".aiff", ".aifc", ".au",   ".snd",
                                                    ".caf", ".ogg",  ".oga",  ".opus", ".mp3"};
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kExtensions.count(extension) > 0 && file.filename().string()[0] != '.';
}

std::vector<fs::path> recordings_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_recording(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> recordings_of(const std::vector<fs::path>& inputs) {
  std::vector<fs::path> files;
  for (const fs::path& input : inputs) {
    std::error_code none;
    if (!fs::is_directory(input, none)) {
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

void add_labelled(const fs::path& recording, const std::string& stem, const fs::path& labels,
                  PartList& list) {
  std::vector<Part> parts;
  std::set<std::string> names;
  for (const Label& label : read_labels(labels)) {
    parts.push_back({recording, labelled_name(stem, label), labels, label});
    if (!names.insert(parts.back().bank).second)
      throw InputError(
          labels.string(), label.line, "start",
          fmt::format("another label starts at {} s too, expected one bank a start", label.start_s));
  }
  note_overlaps(parts, list.notes);
  list.parts.insert(list.parts.end(), parts.begin(), parts.end());
}

}  // namespace

PartList list_parts(const AnalyzerOptions& options) {
  const std::vector<fs::path> recordings = recordings_of(options.inputs);
  if (!options.labels.empty() && recordings.size() != 1)
    throw InputError(
        options.labels.string(),
        fmt::format("is given for {} recordings, expected one (a label file beside each recording, with "
                    "its name and .txt, is found by itself)",
                    recordings.size()));
  const std::map<fs::path, std::string> stems = stems_of(recordings);
  PartList list;
  std::set<std::string> taken;
  for (const fs::path& recording : recordings) {
    const std::string& stem = stems.at(recording);
    if (!taken.insert(stem).second) {
      list.failures.push_back(recording.string() +
                              ": its bank would be named like another's, expected other file names");
      continue;
    }
    fs::path labels = options.labels.empty() ? fs::path(recording).replace_extension(".txt") : options.labels;
    std::error_code none;
    if (options.labels.empty() && !fs::exists(labels, none)) {
      Part part{recording, stem, {}, {}};
      part.label.situation = options.situation;
      list.parts.push_back(part);
      continue;
    }
    try {
      add_labelled(recording, stem, labels, list);
    } catch (const InputError& error) {
      list.failures.push_back(error.what());
    }
  }
  return list;
}

}  // namespace rigsound::analysis
