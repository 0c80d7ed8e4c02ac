// The sounds in a page: are they the ones that were given, and how loud?
#include "report/player.hpp"

#include <doctest/doctest.h>
#include <nettle/base64.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/recording.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

std::vector<float> faded_tone(double hz, double amplitude, double seconds) {
  std::vector<float> x;
  for (std::size_t n = 0; n < static_cast<std::size_t>(seconds * kAnalysisRate); ++n)
    x.push_back(
        static_cast<float>(amplitude * std::sin(2 * M_PI * hz * static_cast<double>(n) / kAnalysisRate)));
  return x;
}

/// The sounds of the page, in its order.
std::vector<std::vector<float>> sounds_in(const std::string& page) {
  const std::string start = "data:audio/flac;base64,";
  const test::TemporaryFolder folder;
  std::vector<std::vector<float>> sounds;
  for (std::size_t at = page.find(start); at != std::string::npos; at = page.find(start, at + 1)) {
    const std::size_t from = at + start.size(), length = page.find('"', at) - from;
    std::string bytes(BASE64_DECODE_LENGTH(length), '\0');
    base64_decode_ctx decoder;
    base64_decode_init(&decoder);
    std::size_t size = 0;
    REQUIRE(base64_decode_update(&decoder, &size, reinterpret_cast<std::uint8_t*>(bytes.data()), length,
                                 page.data() + from) == 1);
    bytes.resize(size);
    const auto file = folder.path / "sound.flac";
    std::ofstream(file, std::ios::binary) << bytes;
    sounds.push_back(read_recording(file).mono);
  }
  return sounds;
}

double peak(const std::vector<float>& x) {
  double highest = 0;
  for (const float v : x) highest = std::max(highest, std::fabs(static_cast<double>(v)));
  return highest;
}

}  // namespace

TEST_CASE("recorded and drilling have one gain, synthesised the drilling's level, none is longer than said") {
  const HeardSounds sounds{faded_tone(500, 0.4, 3.4), faded_tone(500, 0.1, 3.4), faded_tone(700, 0.02, 4), 2};
  const std::string page = player(sounds);
  const auto heard = sounds_in(page);
  REQUIRE(heard.size() == 3);
  for (const auto& sound : heard) CHECK(sound.size() == static_cast<std::size_t>(kHeard_s * kAnalysisRate));
  CHECK(peak(heard[0]) == doctest::Approx(0.89).epsilon(0.001));
  CHECK(peak(heard[1]) == doctest::Approx(0.89 / 4).epsilon(0.001));
  CHECK(peak(heard[2]) == doctest::Approx(0.89 / 4).epsilon(0.001));
  CHECK(page.find("3.0 s from 2.0 s on") != std::string::npos);
  CHECK(page.find("played +6.9 dB") != std::string::npos);
  CHECK(page.find("synthesised +20.9 dB") != std::string::npos);
  for (std::size_t n = 0; n < 1000; ++n) CHECK(std::fabs(heard[1][n] - heard[0][n] / 4) < 1.0f / 32768);
}

TEST_CASE("a short recording is heard as long as it is, and the synthesised no longer") {
  const auto heard =
      sounds_in(player({faded_tone(500, 0.4, 2.1), faded_tone(500, 0.1, 2.1), faded_tone(700, 0.02, 4), 0}));
  REQUIRE(heard.size() == 3);
  for (const auto& sound : heard) CHECK(sound.size() == static_cast<std::size_t>(2.1 * kAnalysisRate));
}
