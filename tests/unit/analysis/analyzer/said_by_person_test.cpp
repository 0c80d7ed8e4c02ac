// A person who says that a recording is drilling is believed; what speaks against it is a warning.
#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "analysis/analyzer/analyzer_workplace.hpp"
#include "analysis/noise.hpp"

using namespace rigsound;
using namespace rigsound::analysis;
namespace fs = std::filesystem;

namespace {

/// Noise, whose clicks are no better than chance gives.
std::vector<double> hiss() {
  TestNoise noise(31);
  std::vector<double> x(2 * 48000);
  for (double& v : x) v = 0.05 * noise.normal();
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
  const AnalyzerResult result = analysed(Workplace(), hiss(), {}, std::nullopt);
  CHECK(result.banks.empty());
  REQUIRE(result.failures.size() == 1);
  CHECK(result.failures[0].find("no drilling found") != std::string::npos);
}

TEST_CASE("a label is believed, and so is a situation given for the whole recording") {
  check_doubted(analysed(Workplace(), hiss(), "0\t2\tnormal\n", std::nullopt));
  const Workplace at;
  check_doubted(analysed(at, hiss(), {}, Situation::kNormal));
  const AnalyzerResult again = analysed(at, hiss(), {}, Situation::kNormal);
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
