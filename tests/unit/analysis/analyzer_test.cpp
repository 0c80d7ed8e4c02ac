// The batch: names, restart, jobs and shards, failures, lint.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "analyzer/source_hash.hpp"
#include "bank/lint.hpp"
#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/report.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/input_error.hpp"
#include "simulate/drillbench_clip.hpp"

using namespace rigsound;
using namespace rigsound::analysis;
namespace fs = std::filesystem;

namespace {

class Workplace {
 public:
  Workplace() : path_(fs::temp_directory_path() / "rigsound_analyzer_test") {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Workplace() { fs::remove_all(path_); }
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A clip as a recording of full scale 1; clips 103 and 112 are among the easy ones.
void write_clip(const fs::path& path, int id, double seconds) {
  std::vector<double> clean = drillbench_clip(id, seconds).clean;
  for (double& v : clean) v *= 0.05;
  write_wave(path, clean, 48000);
}

/// Two recordings, one with two labelled parts, and one that cannot be read.
void write_recordings(const Workplace& at) {
  fs::create_directories(at / "in");
  write_clip(at / "in/whole.wav", 112, 2);
  write_clip(at / "in/two.wav", 103, 4.2);
  write_text(at / "in/two.txt",
             "0.0\t2.0\tnormal rods=2 rock=granite\n2.1\t4.1\toverfeed rods=2 rock=granite\n");
  write_text(at / "in/bad.wav", "this is no sound");
}

AnalyzerOptions options_for(const Workplace& at, const std::string& set) {
  AnalyzerOptions options;
  options.inputs = {at / "in"};
  options.sound_set = at / set;
  options.denoise = false;  // quicker, and all the same here
  options.tool_version = "test";
  return options;
}

/// All files of the sound set but the locks, by relative path.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".lock")
      files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
  return files;
}

AnalysedPart part(const std::string& bank, Situation situation, int rods, double T_0, double level_db) {
  AnalysedPart p;
  p.part.bank = bank;
  p.part.label.situation = situation;
  p.part.label.rods = rods;
  p.T_0 = T_0;
  p.clicks = 10;
  p.figures = {60, 1, 1, 48000 / T_0, level_db, 10, 0.05, 0.05, 0.3, 2};
  return p;
}

bool warns(const std::vector<std::string>& warnings, const std::string& words) {
  for (const std::string& w : warnings)
    if (w.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("SHA-256 of a file is that of its bytes") {
  const Workplace at;
  write_text(at / "abc", "abc");
  CHECK(file_sha256(at / "abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK_THROWS_AS(file_sha256(at / "none"), InputError);
}

TEST_CASE("every part gets its bank, a bad recording stops nothing and is listed") {
  const Workplace at;
  write_recordings(at);
  const AnalyzerResult result = run_analyzer(options_for(at, "set"), {});
  REQUIRE(result.banks.size() == 3);
  CHECK(result.banks[0].part.bank == "two_00000ms");
  CHECK(result.banks[1].part.bank == "two_02100ms");
  CHECK(result.banks[2].part.bank == "whole");
  CHECK(result.banks[0].figures.rate_hz == doctest::Approx(32).epsilon(0.02));
  REQUIRE(result.failures.size() == 1);
  CHECK(result.failures[0].find("bad.wav") != std::string::npos);
  const config::SoundSetIndex index = config::load_index(at / "set");
  REQUIRE(index.banks.size() == 3);
  CHECK(index.banks[1].situation == Situation::kOverfeed);
  CHECK(index.banks[1].rods == 2);
  CHECK(index.rocks == std::vector<std::string>{"granite"});
}

TEST_CASE("banks do not depend on jobs and shards") {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions one = options_for(at, "one"), three = options_for(at, "three"),
                  parts = options_for(at, "parts");
  three.jobs = 3;
  run_analyzer(one, {});
  run_analyzer(three, {});
  CHECK(contents(at / "one") == contents(at / "three"));
  parts.shards = 2;
  std::size_t banks = 0;
  for (parts.shard = 1; parts.shard <= 2; ++parts.shard) banks += run_analyzer(parts, {}).banks.size();
  CHECK(banks == 3);
  for (const auto& [file, text] : contents(at / "one"))
    if (file.find("banks/") == 0) CHECK(contents(at / "parts")[file] == text);
}

TEST_CASE("finished banks are kept, damaged and outdated ones are made again") {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions options = options_for(at, "set");
  options.inputs = {at / "in/two.wav"};
  const auto kept = [&] {
    int count = 0;
    for (const AnalysedPart& p : run_analyzer(options, {}).banks) count += p.kept;
    return count;
  };
  CHECK(kept() == 0);
  const auto first = contents(at / "set");
  CHECK(kept() == 2);
  CHECK(contents(at / "set") == first);

  SUBCASE("figures missing: the run was killed before the bank was done") {
    fs::remove(at / "set/banks/two_00000ms/figures.json");
    CHECK(kept() == 1);
    CHECK(contents(at / "set") == first);
  }
  SUBCASE("a torn clicks.wav") {
    fs::resize_file(at / "set/banks/two_00000ms/clicks.wav", 100);
    CHECK(kept() == 1);
    CHECK(contents(at / "set") == first);
  }
  SUBCASE("other settings") {
    options.clicks = 5;
    CHECK(kept() == 0);
  }
  SUBCASE("another sound under the same name") {
    write_clip(at / "in/two.wav", 112, 4.2);
    CHECK(kept() == 0);
  }
  SUBCASE("a moved label leaves the other part alone") {
    write_text(at / "in/two.txt", "0.0\t2.0\tnormal\n2.2\t4.1\toverfeed\n");
    CHECK(kept() == 1);
  }
  SUBCASE("what a killed run left half-written is swept away") {
    fs::create_directories(at / "set/banks/.two_00000ms.Xy12zW");
    kept();
    CHECK_FALSE(fs::exists(at / "set/banks/.two_00000ms.Xy12zW"));
  }
}

TEST_CASE("what people wrote into soundset.toml stays") {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions options = options_for(at, "set");
  options.inputs = {at / "in/two.wav"};
  run_analyzer(options, {});
  const std::string edited = read_text(at / "set/soundset.toml") +
                             "\n# mine\n[[bank]]\nname = \"two_00000ms\"\nsituation = \"underfeed\"\n";
  write_text(at / "set/soundset.toml", edited);
  options.inputs.push_back(at / "in/whole.wav");
  run_analyzer(options, {});
  const std::string now = read_text(at / "set/soundset.toml");
  CHECK(now.compare(0, edited.size(), edited) == 0);
  CHECK(now.find("\"whole\"", edited.size()) != std::string::npos);
}

TEST_CASE("a broken soundset.toml is told before anything is analysed") {
  const Workplace at;
  write_recordings(at);
  fs::create_directories(at / "set");
  write_text(at / "set/soundset.toml", "format = 99\n");
  int analysed = 0;
  CHECK_THROWS_AS(run_analyzer(options_for(at, "set"), [&](int done, int) { analysed = done; }), InputError);
  CHECK(analysed == 0);
  CHECK(read_text(at / "set/soundset.toml") == "format = 99\n");
}

TEST_CASE("noise is no drilling and leaves no bank") {
  const Workplace at;
  fs::create_directories(at / "in");
  SplitMix stream(9);
  std::vector<double> noise = stream.normals(96000);
  for (double& v : noise) v *= 0.05;
  write_wave(at / "in/noise.wav", noise, 48000);
  const AnalyzerResult result = run_analyzer(options_for(at, "set"), {});
  CHECK(result.banks.empty());
  REQUIRE(result.failures.size() == 1);
  CHECK(result.failures[0].find("no drilling found") != std::string::npos);
  CHECK_FALSE(fs::exists(at / "set"));
}

TEST_CASE("a label outside its recording, and labels for several recordings, are refused") {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions options = options_for(at, "set");
  options.labels = at / "in/two.txt";
  CHECK_THROWS_AS(run_analyzer(options, {}), InputError);
  options.inputs = {at / "in/whole.wav"};
  const AnalyzerResult result = run_analyzer(options, {});
  CHECK(result.banks.size() == 1);
  REQUIRE(result.failures.size() == 1);
  CHECK(result.failures[0].find((at / "in/two.txt").string() + ":2: end: ") == 0);
  CHECK(result.failures[0].find("recording's end") != std::string::npos);
}

TEST_CASE("labels that overlap are analysed both, and told") {
  const Workplace at;
  write_recordings(at);
  write_text(at / "in/two.txt", "0.0\t2.2\tnormal\n2.17\t4.1\toverfeed\n0.5\t2.5\tunderfeed\n");
  AnalyzerOptions options = options_for(at, "set");
  options.inputs = {at / "in/two.wav"};
  const AnalyzerResult result = run_analyzer(options, {});
  CHECK(result.banks.size() == 3);
  REQUIRE(result.notes.size() == 2);  // 30 ms are a hand's slack
  CHECK(result.notes[0].find((at / "in/two.txt").string() + ":3: start: overlaps the label of line 1") == 0);
}

TEST_CASE("a labelled part is the same as its stretch cut out") {
  const Workplace at;
  fs::create_directories(at / "in");
  std::vector<double> clean = drillbench_clip(103, 6).clean;
  for (double& v : clean) v *= 0.05;
  write_wave(at / "in/long.wav", clean, 48000);
  write_wave(at / "in/cut.wav", std::vector<double>(clean.begin() + 96000, clean.begin() + 192000), 48000);
  write_text(at / "in/long.txt", "2\t4\tnormal\n");
  const AnalyzerResult result = run_analyzer(options_for(at, "set"), {});
  REQUIRE(result.banks.size() == 2);
  CHECK(read_text(at / "set/banks/cut/clicks.wav") == read_text(at / "set/banks/long_02000ms/clicks.wav"));
}

TEST_CASE("a strike or two in a minute of something else are no drilling") {
  const Workplace at;
  fs::create_directories(at / "in");
  SplitMix stream(9);
  std::vector<double> mostly_noise = stream.normals(24 * 48000);
  for (double& v : mostly_noise) v *= 1e-3;
  const std::vector<double> drilling = drillbench_clip(103, 4).clean;
  for (std::size_t n = 0; n < drilling.size(); ++n) mostly_noise[n + 4 * 48000] += 0.05 * drilling[n];
  write_wave(at / "in/rare.wav", mostly_noise, 48000);
  const AnalyzerResult result = run_analyzer(options_for(at, "set"), {});
  CHECK(result.banks.empty());
  REQUIRE(result.failures.size() == 1);
  CHECK(result.failures[0].find("in 1 of 6 segments") != std::string::npos);
}

TEST_CASE("the report is one page without anything from outside") {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions options = options_for(at, "set");
  options.report = ReportSections::kWrite;
  const AnalyzerResult result = run_analyzer(options, {});
  write_report(at / "report.html", at / "set", result);
  const std::string page = read_text(at / "report.html");
  for (const AnalysedPart& p : result.banks)
    CHECK(page.find("<section id=\"" + p.part.bank + "\">") != std::string::npos);
  for (const char* title :
       {"Recording", "Background, taken away", "Detected clicks", "Envelope", "Gaps between clicks",
        "Amplitudes of clicks", "Third-octave levels", "Modulation spectrum", "Click 10"})
    CHECK(page.find(title) != std::string::npos);
  CHECK(page.find("bad.wav") != std::string::npos);
  for (const char* outside : {"http:", "https:", "src=", "<script", "@import", "url("})
    CHECK(page.find(outside) == std::string::npos);
  CHECK(page.find("nan") == std::string::npos);
}

TEST_CASE("lint warns about what it should, and about nothing else") {
  CHECK(lint_bank(part("good", Situation::kNormal, 1, 1200, -20), 10).empty());
  const auto with = [](auto change) {
    AnalysedPart p = part("p", Situation::kNormal, 1, 1200, -20);
    change(p);
    return lint_bank(p, 10);
  };
  CHECK(warns(with([](AnalysedPart& p) { p.figures.clicks_found = 8; }), "too few clicks"));
  CHECK(warns(with([](AnalysedPart& p) { p.clicks = 6; }), "too few clicks"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.snr_db = -5; }), "low SNR"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.longest_click_s = 0.01; }), "shorter than their decay"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.rate_hz = 95; }), "rate out of range"));
  CHECK(warns(with([](AnalysedPart& p) { p.figures.segments = 3; }), "1 of 3 segments"));
}

TEST_CASE("lint finds the bank that is out of order in its series") {
  std::vector<AnalysedPart> rods = {
      part("r1", Situation::kNormal, 1, 1200, -20), part("r3", Situation::kNormal, 3, 1240, -21),
      part("r5", Situation::kNormal, 5, 1500, -22), part("r7", Situation::kNormal, 7, 1320, -23)};
  lint_series(rods);
  CHECK(rods[0].warnings.empty());
  CHECK(rods[1].warnings.empty());
  CHECK(warns(rods[2].warnings, "T0"));
  CHECK_FALSE(warns(rods[2].warnings, "level"));
  CHECK(rods[3].warnings.empty());

  std::vector<AnalysedPart> feed = {part("u", Situation::kUnderfeed, 1, 1300, -15),
                                    part("n", Situation::kNormal, 1, 1200, -20),
                                    part("o", Situation::kOverfeed, 1, 1000, -22)};
  lint_series(feed);
  CHECK(warns(feed[0].warnings, "level"));
  CHECK(feed[1].warnings.empty());
  CHECK(warns(feed[2].warnings, "T0"));
}
