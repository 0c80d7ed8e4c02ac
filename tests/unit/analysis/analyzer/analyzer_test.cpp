// The batch: names, restart, jobs and shards, failures, report.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "analysis/analyzer/analyzer_workplace.hpp"
#include "rigsound/analysis/analyzer.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/analysis/report.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;
using namespace rigsound::analysis;
namespace fs = std::filesystem;

namespace {

/// All files of the sound set but the locks, by relative path.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() != ".lock")
      files[fs::relative(entry.path(), folder).string()] = read_text(entry.path());
  return files;
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
  CHECK(index.banks[1].feed_bar == 150);
  CHECK(index.banks[1].percussion_bar == 170);
  CHECK(index.banks[0].feed_bar == 0);
  REQUIRE(index.rocks.size() == 1);
  CHECK(index.rocks[0].name == "granite");
}

TEST_CASE("each bank is told when it is on disk, before the next is begun") {
  const Workplace at;
  write_recordings(at);
  std::vector<std::string> told;
  AnalyzerListener listener;
  listener.done = [&](const AnalysedPart& part) {
    told.push_back(part.part.bank);
    CHECK(fs::exists(at / "set/banks" / part.part.bank / "figures.json"));
    const auto folders = fs::directory_iterator(at / "set/banks");
    CHECK(std::distance(begin(folders), end(folders)) == std::ptrdiff_t(told.size()));
  };
  run_analyzer(options_for(at, "set"), listener);
  CHECK(told == std::vector<std::string>{"two_00000ms", "two_02100ms", "whole"});
  told.clear();
  listener.done = [&](const AnalysedPart& part) {
    told.push_back(part.part.bank);
    CHECK(part.kept);
  };
  run_analyzer(options_for(at, "set"), listener);
  CHECK(told.size() == 3);
}

TEST_CASE("banks do not depend on jobs and shards" * doctest::test_suite("long")) {
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

TEST_CASE("finished banks are kept, damaged and outdated ones are made again" * doctest::test_suite("long")) {
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

TEST_CASE("what a person refined is kept when its bank is analysed anew, and said" *
          doctest::test_suite("long")) {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions options = options_for(at, "set");
  run_analyzer(options, {});
  const fs::path bank = at / "set/banks/whole", kept = bank / "refined.json.old";
  write_text(bank / "refined.json", "by hand");
  const auto told = [](const AnalyzerResult& result) {
    return std::count_if(result.notes.begin(), result.notes.end(), [](const std::string& note) {
      return note.find("banks/whole: ") != std::string::npos &&
             note.find("refined.json.old") != std::string::npos;
    });
  };
  options.clicks = 7;
  CHECK(told(run_analyzer(options, {})) == 1);
  CHECK_FALSE(fs::exists(bank / "refined.json"));
  REQUIRE(fs::exists(kept));
  CHECK(read_text(kept) == "by hand");
  options.clicks = 8;
  CHECK(told(run_analyzer(options, {})) == 0);
  CHECK(read_text(kept) == "by hand");
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
  const AnalyzerListener listener{{}, [&](int done, int) { analysed = done; }};
  CHECK_THROWS_AS(run_analyzer(options_for(at, "set"), listener), InputError);
  CHECK(analysed == 0);
  CHECK(read_text(at / "set/soundset.toml") == "format = 99\n");
}

TEST_CASE("four seconds of drilling in a minute of noise are a bank, of the clicks that the chain finds" *
          doctest::test_suite("long")) {
  constexpr int kId = 103, kStart = 28 * 48000;
  const Workplace at;
  fs::create_directories(at / "in");
  SplitMix stream(9);
  std::vector<double> sound = stream.normals(60 * 48000);
  for (double& v : sound) v *= 0.001;
  const DrillBenchClip clip = drillbench_clip(kId, 4);
  for (std::size_t n = 0; n < clip.clean.size(); ++n) sound[kStart + n] += 0.05 * clip.clean[n];
  write_wave(at / "in/minute.wav", sound, 48000);
  const AnalyzerOptions options = options_for(at, "set");
  const AnalyzerResult result = run_analyzer(options, {});
  REQUIRE(result.banks.size() == 1);

  ChainOptions chain;
  chain.denoise = options.denoise;
  const ClickTrain found = run_chain(read_recording(at / "in/minute.wav").mono, chain).clicks;
  CHECK(result.banks[0].figures.clicks_found == int(found.P.size()));
  CHECK(result.banks[0].mean_gap_samples == doctest::Approx(clip.T0).epsilon(0.02));
  REQUIRE(!result.banks[0].warnings.empty());
  CHECK(result.banks[0].warnings[0] == "drilling in 2 of 20 segments only");
  std::size_t impacts = 0;
  for (const SimulatedClick& click : clip.clicks) {
    if (click.kind == ClickKind::kBounce || click.P >= 4 * 48000 - 480) continue;  // the last is cut off
    ++impacts;
    CAPTURE(click.P);
    CHECK(std::count_if(found.P.begin(), found.P.end(),
                        [&](int P) { return std::abs(P - kStart - click.P) <= 96; }) == 1);
  }
  CHECK(found.P.size() == impacts);
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
        "Amplitudes of clicks", "Third-octave levels", "Envelope modulation", "Click 10"})
    CHECK(page.find(title) != std::string::npos);
  CHECK(page.find("bad.wav") != std::string::npos);
  for (const char* outside :
       {"http:", "https:", "src=\"/", "src=\".", "<script src", "<link", "@import", "url("})
    CHECK(page.find(outside) == std::string::npos);
  std::string words = page;  // without what only looks like words
  for (std::size_t from = words.find("base64,"); from != std::string::npos;
       from = words.find("base64,", from))
    words.erase(from, words.find('"', from) - from);
  CHECK(words.find("nan") == std::string::npos);
}

TEST_CASE("every bank has a page of its own, with its sound, which the report links to") {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions options = options_for(at, "set");
  options.report = ReportSections::kWrite;
  const AnalyzerResult result = run_analyzer(options, {});
  REQUIRE(!result.banks.empty());
  fs::create_directories(at / "pages");
  write_report(at / "pages/report.html", at / "set", result);
  const std::string report = read_text(at / "pages/report.html");
  const auto count = [](const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) ++found;
    return found;
  };
  for (const AnalysedPart& p : result.banks) {
    const std::string page = read_text(at / "set/banks" / p.part.bank / "report.html");
    CHECK(page.rfind("<!doctype html>", 0) == 0);
    for (const char* part : {"<meta charset=\"utf-8\">", "<title>", "<style>", "prefers-color-scheme: dark",
                             "@media (max-width: 640px)", "</html>"})
      CHECK(page.find(part) != std::string::npos);
    CHECK(page.find("<title>Bank " + p.part.bank) != std::string::npos);
    CHECK(report.find("href=\"../set/banks/" + p.part.bank + "/report.html\"") != std::string::npos);
    CHECK(count(page, "data:audio/flac;base64,") == 3);
    CHECK(page.size() < 2000000);
    for (const char* take : {"recorded", "drilling", "synthesised"})
      CHECK(page.find(std::string("<audio controls loop preload=\"metadata\" aria-label=\"") + take) !=
            std::string::npos);
    // Each symbol of the figures is explained below, and nothing is drawn that is not described.
    const std::size_t legend = page.find("What the symbols mean");
    REQUIRE(legend != std::string::npos);
    std::size_t symbols = 0;
    for (std::size_t i = page.find("<dt>"); i < legend; i = page.find("<dt>", i + 1), ++symbols) {
      const std::string symbol = page.substr(i, page.find("</dt>", i) - i);
      CHECK(page.find(symbol, legend) != std::string::npos);
    }
    CHECK(symbols == 11);
    CHECK(count(page, "<svg") == count(page, "role=\"img\" aria-label=\""));
  }
  CHECK(count(report, "data:audio/flac;base64,") == 3 * result.banks.size());
}

TEST_CASE("a page of an older form is made again") {
  const Workplace at;
  write_recordings(at);
  AnalyzerOptions options = options_for(at, "set");
  options.report = ReportSections::kWrite;
  const AnalyzerResult result = run_analyzer(options, {});
  const fs::path page = at / "set/banks" / result.banks.front().part.bank / "report.html";
  std::ofstream(page) << "<dl></dl>";
  CHECK_FALSE(run_analyzer(options, {}).banks.front().kept);
  CHECK(run_analyzer(options, {}).banks.front().kept);
  CHECK(read_text(page).rfind("<!doctype html>", 0) == 0);
}
