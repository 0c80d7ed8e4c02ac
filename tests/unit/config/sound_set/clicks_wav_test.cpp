// Clicks of a WAV: where its cue points say, at unit norm, or refused with what is wrong.
#include "sound_set/clicks_wav.hpp"

#include <doctest/doctest.h>
#include <sndfile.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/click_bank.hpp"
#include "sound_set/click_store.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;

namespace {

struct CueWav {
  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path / "clicks.wav";

  CueWav(const std::vector<float>& samples, const std::vector<std::uint32_t>& cues_at,
         int type = SF_FORMAT_WAV) {
    SF_INFO format{};
    format.samplerate = 48000, format.channels = 1, format.format = type | SF_FORMAT_FLOAT;
    SNDFILE* sound = sf_open(file.c_str(), SFM_WRITE, &format);
    REQUIRE(sound != nullptr);
    SF_CUES cues{};
    for (const std::uint32_t at : cues_at) {
      SF_CUE_POINT& cue = cues.cue_points[cues.cue_count++];
      cue.indx = static_cast<std::int32_t>(cues.cue_count);
      cue.position = cue.sample_offset = at;
      cue.fcc_chunk = 0x61746164;
    }
    sf_command(sound, SFC_SET_CUE, &cues, sizeof cues);
    sf_write_float(sound, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(sound);
  }

  config::Clicks clicks() const {
    config::ClickStore store;
    return config::read_clicks_wav(file, 48000, store);
  }
  /// What is said of it, behind its name.
  std::string said() const {
    const std::string text = test::complaint([&] { clicks(); });
    return text.empty() ? text : text.substr(file.string().size());
  }
};

}  // namespace

TEST_CASE("clicks begin at the first cue point and end at the next, or with the file") {
  const config::Clicks clicks = CueWav({9, 9, 0.6F, 0.8F, 1, 0, 0.8F, -0.6F, 0}, {2, 4, 6}).clicks();
  REQUIRE(clicks.size() == 3);
  CHECK(clicks[0] == Click{0.6F, 0.8F});
  CHECK(clicks[1] == Click{1, 0});
  CHECK(clicks[2] == Click{0.8F, -0.6F, 0});
}

TEST_CASE("cue points ascend and lie before the end") {
  const std::vector<float> six(6, 0.5F);
  const auto wrong = [](int cue, int sample) {
    return ": cue point " + std::to_string(cue) + " at sample " + std::to_string(sample) +
           " is out of order or behind the end, expected ascending starts of clicks";
  };
  CHECK(CueWav(six, {0, 5}).said().empty());
  CHECK(CueWav(six, {0, 6}).said() == wrong(2, 6));
  CHECK(CueWav(six, {3, 3}).said() == wrong(1, 3));
  CHECK(CueWav(six, {0, 4, 2}).said() == wrong(2, 4));
  CHECK(CueWav(six, {0, 7, 8}).said() == wrong(1, 0));
  CHECK(CueWav(six, {6}).said() == wrong(1, 6));
}

TEST_CASE("a click that is not of unit norm is made so, one that is stays to the bit") {
  const auto nearly = static_cast<float>(1 - 0.5 * kUnitNormTolerance);
  CHECK(CueWav({nearly, 0}, {0}).clicks()[0] == Click{nearly, 0});
  const auto less = static_cast<float>(1 - 2 * kUnitNormTolerance);
  CHECK(CueWav({less, 0}, {0}).clicks()[0] == Click{1, 0});
  const auto more = static_cast<float>(1 + 2 * kUnitNormTolerance);
  CHECK(CueWav({more, 0}, {0}).clicks()[0] == Click{1, 0});
}

TEST_CASE("the click that is wrong is named by its number") {
  CHECK(CueWav({1, 0, 0, 0}, {0, 2}).said() == ": click 2 is silent, expected a sound at every cue point");
  CHECK(CueWav({1, 0, 0.9e-10F, 0}, {0, 2}).said() ==
        ": click 2 is silent, expected a sound at every cue point");
  CHECK(CueWav({1, 0, 1e-9F, 0}, {0, 2}).said().empty());
  CHECK(CueWav({1, 0, 1, INFINITY}, {0, 2}).said() == ": click 2 has samples that are not finite numbers");
  CHECK(CueWav({1, 0}, {}).said() == ": has no cue points, expected one at the start of each click");
}

TEST_CASE("a long file that was cut off by a sample is refused, too") {
  const CueWav wav(std::vector<float>(100000, 0.01F), {0});
  CHECK(wav.said().empty());
  const auto size = std::filesystem::file_size(wav.file);
  std::filesystem::resize_file(wav.file, size - 4);
  CHECK(wav.said() ==
        ": is cut off after " + std::to_string(size - 4) + " bytes, expected " + std::to_string(size));
}
