// A person who says that a recording is drilling is believed; what speaks against it is a warning.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/noise.hpp"
#include "analyzer/analyzer_workplace.hpp"

using namespace rigsound;
using namespace rigsound::analysis;
namespace fs = std::filesystem;

namespace {

/// Sharp blows of noise, every other one far louder, at a pace between 2 and 3 a second: no percussive drill.
std::vector<double> hammering() {
  TestNoise noise(31);
  std::vector<double> x(4 * 48000);
  double next = 4000;
  for (int blow = 0; next + 9000 < static_cast<double>(x.size()); ++blow) {
    const auto at = static_cast<std::size_t>(next);
    for (std::size_t n = 0; n < 9000; ++n)
      x[at + n] += (blow % 2 ? 0.3 : 0.05) * noise.normal() * std::exp(-static_cast<double>(n) / 900);
    next += 16000 + 8000 * noise.uniform();
  }
  for (double& v : x) v += 1e-4 * noise.normal();
  return x;
}

AnalyzerResult analysed(const Workplace& at, const std::vector<double>& x, const std::string& label,
                        std::optional<Situation> said) {
  fs::create_directories(at / "in");
  write_wave(at / "in/a.wav", x, 48000);
  if (!label.empty()) write_text(at / "in/a.txt", label);
  AnalyzerOptions options = options_for(at, "set");
  options.situation = said;
  return run_analyzer(options, {});
}

void check_doubted(const AnalyzerResult& result) {
  CHECK(result.failures.empty());
  REQUIRE(result.banks.size() == 1);
  REQUIRE(!result.banks[0].warnings.empty());
  CHECK(result.banks[0].warnings[0].find("it may be no drilling: ") == 0);
}

}  // namespace

TEST_CASE("nobody has said that it is drilling: the verdict decides") {
  const AnalyzerResult result = analysed(Workplace(), hammering(), {}, std::nullopt);
  CHECK(result.banks.empty());
  REQUIRE(result.failures.size() == 1);
  CHECK(result.failures[0].find("no drilling found") != std::string::npos);
}

TEST_CASE("a label is believed, and so is a situation given for the whole recording") {
  check_doubted(analysed(Workplace(), hammering(), "0\t4\tnormal\n", std::nullopt));
  const Workplace at;
  check_doubted(analysed(at, hammering(), {}, Situation::kNormal));
  const AnalyzerResult again = analysed(at, hammering(), {}, Situation::kNormal);
  check_doubted(again);
  CHECK(again.banks[0].kept);
}

TEST_CASE("a labelled part in which no clicks are found fails") {
  std::vector<double> tone(2 * 48000);
  for (std::size_t n = 0; n < tone.size(); ++n) tone[n] = 0.1 * std::sin(static_cast<double>(n) / 9);
  const AnalyzerResult result = analysed(Workplace(), tone, "0\t2\tnormal\n", std::nullopt);
  CHECK(result.banks.empty());
  REQUIRE(result.failures.size() == 1);
  CHECK(result.failures[0].find("no clicks found") != std::string::npos);
}
