// Which stretch of a recording becomes a part, and which does not.
#include <doctest/doctest.h>

#include "analysis/analyzer/analyzer_workplace.hpp"
#include "rigsound/machine/input_error.hpp"

using namespace rigsound;
using namespace rigsound::analysis;
namespace fs = std::filesystem;

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
