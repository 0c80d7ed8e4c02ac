#include "analyzer/finished_bank.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "report/bank_page.hpp"
#include "rigsound/analysis/bank_comparison.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/json.hpp"
#include "rigsound/config/refinement.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

// Raised whenever the chain or the bank builder changes what it computes: older banks are then analysed anew.
constexpr int kAnalysisRevision = 16;

constexpr const char* kFiguresFile = "figures.json";
constexpr const char* kFormerRefinementFile = "refined.json.old";

struct Figure {
  const char* key;
  double BankFigures::*value;
};
constexpr Figure kFigures[] = {
    {"rate_hz", &BankFigures::rate_hz},
    {"level_db", &BankFigures::level_db},
    {"snr_db", &BankFigures::snr_db},
    {"decay_s", &BankFigures::decay_s},
    {"longest_click_s", &BankFigures::longest_click_s},
    {"ltas_error_db", &BankFigures::ltas_error_db},
    {"ltas_denoised_error_db", &BankFigures::ltas_denoised_error_db},
    {"modulation_error_db", &BankFigures::modulation_error_db},
};

fs::path bank_folder(const fs::path& sound_set, const std::string& bank) {
  return sound_set / "banks" / bank;
}

fs::path figures_path(const fs::path& sound_set, const std::string& bank) {
  return bank_folder(sound_set, bank) / kFiguresFile;
}

std::string figures_text(const BankFigures& figures) {
  Json json;
  json["clicks_found"] = figures.clicks_found;
  json["segments"] = figures.segments;
  json["segments_drilling"] = figures.segments_drilling;
  for (const Figure& f : kFigures) json[f.key] = figures.*f.value;  // infinity becomes null
  json["machine"] = figures.machine;
  json["machine_rates_hz"] = figures.machine_rates_hz;
  json["doubt"] = figures.doubt;
  return config::json_lines(json) + "\n";
}

BankFigures read_figures(const fs::path& path) {
  std::ifstream in(path);
  const Json json = config::parsed_json(std::string(std::istreambuf_iterator<char>(in), {}));
  BankFigures figures;
  figures.clicks_found = json.at("clicks_found");
  figures.segments = json.at("segments");
  figures.segments_drilling = json.at("segments_drilling");
  figures.machine = json.at("machine");
  figures.machine_rates_hz = json.at("machine_rates_hz").get<std::vector<double>>();
  figures.doubt = json.at("doubt");
  for (const Figure& f : kFigures)
    figures.*f.value =
        json.at(f.key).is_null() ? std::numeric_limits<double>::infinity() : json.at(f.key).get<double>();
  return figures;
}

/// What a person refined in the bank that stands there now, whether it reads or not.
std::optional<config::FileBeside> former_refinement(const fs::path& folder) {
  for (const char* name : {config::kRefinementFile, kFormerRefinementFile})
    if (std::ifstream in(folder / name, std::ios::binary); in)
      return config::FileBeside{kFormerRefinementFile, {std::istreambuf_iterator<char>(in), {}}};
  return std::nullopt;
}

}  // namespace

std::string settings_of(const Part& part, const AnalyzerOptions& options) {
  std::string text =
      fmt::format("revision={} method={} denoise={} clicks={} labelled={} machine={}", kAnalysisRevision,
                  options.method == Method::kPaper ? "paper" : "click-nmf", options.denoise ? "yes" : "no",
                  options.clicks, part.labelled ? "yes" : "no", options.machine);
  if (!part.whole())
    text += fmt::format(" start_s={:.6f} end_s={:.6f}", part.label.start_s, part.label.end_s);
  return text;
}

Stretch stretch_of(const std::string& settings) {
  Stretch stretch;
  std::istringstream words(settings);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) continue;
    const auto read = [&](double& to) {
      std::from_chars(word.data() + equals + 1, word.data() + word.size(), to);
    };
    if (word.compare(0, equals, "start_s") == 0) read(stretch.start_s);
    if (word.compare(0, equals, "end_s") == 0) read(stretch.end_s);
  }
  return stretch;
}

ChainOptions chain_of(const std::string& settings) {
  ChainOptions chain;
  std::istringstream words(settings);
  for (std::string word; words >> word;) {
    if (word == "method=paper") chain.method = Method::kPaper;
    if (word == "denoise=no") chain.denoise = false;
    if (word == "labelled=yes") chain.labelled = true;
    if (word == "machine=2") chain.machine = 2;
  }
  return chain;
}

std::optional<AnalysedPart> finished_part(const Part& part, const std::string& sha256,
                                          const AnalyzerOptions& options) {
  const fs::path folder = bank_folder(options.sound_set, part.bank);
  const fs::path page = bank_page_path(options.sound_set, part.bank);
  std::error_code none;
  if (!fs::exists(figures_path(options.sound_set, part.bank), none)) return std::nullopt;
  if (options.report == ReportSections::kWrite && section_in(page).empty()) return std::nullopt;
  try {
    const config::StoredBank stored = config::load_bank(folder);
    if (stored.provenance.source_sha256 != sha256 || stored.provenance.settings != settings_of(part, options))
      return std::nullopt;
    AnalysedPart finished{
        part, true, stored.bank.mean_gap_samples, static_cast<int>(stored.bank.clicks.size()), {}, {}};
    finished.figures = read_figures(figures_path(options.sound_set, part.bank));
    return finished;
  } catch (const InputError&) {
    return std::nullopt;  // damaged: made anew
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string save_part(const AnalysedPart& analysed, const ClickBank& bank, const std::string& sha256,
                      const std::string& page, const AnalyzerOptions& options) {
  config::Provenance provenance;
  provenance.source_file = analysed.part.recording.string();
  provenance.source_sha256 = sha256;
  provenance.settings = settings_of(analysed.part, options);
  provenance.tool_version = options.tool_version;
  std::vector<config::FileBeside> beside = {{kFiguresFile, figures_text(analysed.figures)}};
  if (!page.empty())
    beside.push_back({bank_page_path(options.sound_set, bank.name).filename().string(), page});
  const fs::path folder = bank_folder(options.sound_set, bank.name);
  const auto former = former_refinement(folder);
  const bool was_refined = fs::exists(folder / config::kRefinementFile);
  if (former) beside.push_back(*former);
  config::save_bank(options.sound_set, bank, provenance, beside);
  return was_refined
             ? fmt::format("{}: its clicks are new, so it plays as analysed; what was refined is kept in {}",
                           folder.string(), kFormerRefinementFile)
             : "";
}

}  // namespace rigsound::analysis
