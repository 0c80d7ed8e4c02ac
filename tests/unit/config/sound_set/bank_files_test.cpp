#include "rigsound/config/bank_files.hpp"

#include <doctest/doctest.h>
#include <sndfile.h>

#include <limits>

#include "config/sound_set/example_bank.hpp"
#include "replaced.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/bank_resampling.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::test;
namespace fs = std::filesystem;

namespace {

const config::Provenance kProvenance{"quarry \"A\".wav", std::string(64, 'a'), "denoise=on seed=0", "0.1.0"};

void replace(const fs::path& file, std::string_view old_text, std::string_view new_text) {
  const std::string text = replaced(content(file), old_text, new_text);
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace

TEST_CASE("a bank comes back from disk as it was saved") {
  TemporaryFolder set;
  const ClickBank bank = example_bank("normal-1", 44100, 300);
  config::save_bank(set.path, bank, kProvenance);
  const config::StoredBank stored = config::load_bank(set.path / "banks/normal-1");
  CHECK(stored.bank.name == "normal-1");
  CHECK(stored.bank.sample_rate == 44100);
  CHECK(stored.bank.mean_gap_samples == bank.mean_gap_samples);
  CHECK(stored.bank.gap_deviation_samples == bank.gap_deviation_samples);
  CHECK(stored.bank.gap_correlation == bank.gap_correlation);
  CHECK(stored.bank.mean_amplitude == bank.mean_amplitude);
  CHECK(stored.bank.decay == bank.decay);
  CHECK(stored.bank.gain_db == bank.gain_db);
  CHECK(stored.bank.clicks == bank.clicks);
  CHECK(stored.provenance.source_file == kProvenance.source_file);
  CHECK(stored.provenance.settings == kProvenance.settings);
}

TEST_CASE("the same bank gives the same bytes, so that sets can be compared") {
  TemporaryFolder a, b;
  config::save_bank(a.path, example_bank("x"), kProvenance);
  config::save_bank(b.path, example_bank("x"), kProvenance);
  for (const char* file : {"banks/x/bank.json", "banks/x/clicks.wav"})
    CHECK(content(a.path / file) == content(b.path / file));
}

TEST_CASE("the clicks lie end to end with cue points that other programs read") {
  TemporaryFolder set;
  const ClickBank bank = example_bank("x");
  config::save_bank(set.path, bank, kProvenance);
  SF_INFO format{};
  SNDFILE* sound = sf_open((set.path / "banks/x/clicks.wav").c_str(), SFM_READ, &format);
  REQUIRE(sound != nullptr);
  SF_CUES cues{};
  CHECK(sf_command(sound, SFC_GET_CUE, &cues, sizeof cues) == SF_TRUE);
  sf_close(sound);
  REQUIRE(cues.cue_count == bank.clicks.size());
  std::uint32_t start = 0;
  for (std::uint32_t i = 0; i < cues.cue_count; ++i) {
    CHECK(cues.cue_points[i].sample_offset == start);
    start += static_cast<std::uint32_t>(bank.clicks[i].size());
  }
  CHECK(format.frames == start);
}

TEST_CASE("saving over a bank replaces it whole, and a refused one leaves the old in place") {
  TemporaryFolder set;
  config::save_bank(set.path, example_bank("x"), kProvenance);
  config::save_bank(set.path, example_bank("x", 48000, 9), kProvenance);
  ClickBank wrong = example_bank("x", 48000, 2);
  wrong.gap_deviation_samples = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(config::save_bank(set.path, wrong, kProvenance), InputError);
  CHECK(config::load_bank(set.path / "banks/x").bank.clicks.size() == 9);
  CHECK(std::distance(fs::directory_iterator(set.path / "banks"), {}) == 1);
}

TEST_CASE("names cannot leave the sound set") {
  TemporaryFolder set;
  for (const char* name : {"", "..", "a/b", ".hidden", "a b"})
    CHECK_THROWS_AS(config::save_bank(set.path, example_bank(name), kProvenance), InputError);
  CHECK_FALSE(fs::exists(set.path / "banks"));
}

TEST_CASE("wrong numbers are refused with file, line and key") {
  TemporaryFolder set;
  config::save_bank(set.path, example_bank("x"), kProvenance);
  const fs::path json = set.path / "banks/x/bank.json";
  const auto load = [&] { config::load_bank(set.path / "banks/x"); };
  const std::string good = content(json);
  const auto refused = [&](std::string_view old_text, std::string_view new_text,
                           const std::string& expected) {
    replace(json, old_text, new_text);
    CHECK(complaint(load) == json.string() + expected);
    std::ofstream(json, std::ios::binary) << good;
  };
  refused("\"T0\": 1600.0", "\"T0\": -1", ":4: T0: is -1 samples, expected 40...192000 samples");
  refused("\"T0\"", "\"T_0\"", ":1: T0: is missing");
  refused("1600.0", "\"fast\"", ":4: T0: is text, expected a number, 40...192000 samples");
  refused("\"format\": 1", "\"format\": 7", ":2: format: version 7 is not known, expected 1");
  refused("\"T0\": 1600.0", "\"T0\": 100", ":4: T0: is 100 samples, expected 240...48000 samples");
  refused("\"sigma_T\": ", "\"sigma_T\": 99", ":5: sigma_T: is 9994.117647, expected at most 2 T0, 3200");
  refused("\"alpha_a\": 0.00125", "\"alpha_a\": -3",
          ":13: alpha_a: times N_a is -144, expected at least -100: no number is as large as the attack's "
          "exponential");
  refused("1600.0,", "1600.0", ":5: is not valid JSON here");
  replace(json, "48000", "44100");
  CHECK(complaint(load) == (set.path / "banks/x/clicks.wav").string() +
                               ": 48000 Hz, expected the sample_rate of bank.json, 44100 Hz");
}

TEST_CASE("a clicks.wav that was cut off is refused, however little is missing") {
  TemporaryFolder set;
  config::save_bank(set.path, example_bank("x"), kProvenance);
  const fs::path wav = set.path / "banks/x/clicks.wav";
  const auto size = fs::file_size(wav);
  for (const auto left : {size - 4, size / 2}) {
    fs::resize_file(wav, left);
    CHECK(complaint([&] { config::load_bank(set.path / "banks/x"); }) ==
          wav.string() + ": is cut off after " + std::to_string(left) + " bytes, expected " +
              std::to_string(size));
  }
}

TEST_CASE("a WAV without cue points, with NaN or with silence is refused") {
  TemporaryFolder set;
  config::save_bank(set.path, example_bank("x"), kProvenance);
  const fs::path wav = set.path / "banks/x/clicks.wav";
  const auto load = [&] { config::load_bank(set.path / "banks/x"); };
  const auto write = [&](std::vector<float> samples, bool cue) {
    SF_INFO format{};
    format.samplerate = 48000, format.channels = 1, format.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
    SNDFILE* sound = sf_open(wav.c_str(), SFM_WRITE, &format);
    SF_CUES cues{};
    cues.cue_count = 1;
    cues.cue_points[0].indx = 1;
    cues.cue_points[0].fcc_chunk = 0x61746164;
    if (cue) sf_command(sound, SFC_SET_CUE, &cues, sizeof cues);
    sf_write_float(sound, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(sound);
  };
  write({0.5F, 0.5F}, false);
  CHECK(complaint(load).find("no cue points") != std::string::npos);
  write({0.5F, std::numeric_limits<float>::quiet_NaN()}, true);
  CHECK(complaint(load).find("click 1 has samples that are not finite") != std::string::npos);
  write({0, 0, 0}, true);
  CHECK(complaint(load).find("click 1 is silent") != std::string::npos);
  write({3, 4}, true);
  CHECK(config::load_bank(set.path / "banks/x").bank.clicks[0] == Click{0.6F, 0.8F});
}

TEST_CASE("a bank at another rate keeps its times in seconds and its waveform") {
  const ClickBank low = example_bank("x", 44100), high = example_bank("x", 96000);
  config::BankResampler resampler(96000);
  resampler.resampled(example_bank("of another rate", 32000));
  const ClickBank made = resampler.resampled(low);
  CHECK(made.mean_gap_samples == doctest::Approx(high.mean_gap_samples));
  CHECK(made.gap_deviation_samples == doctest::Approx(high.gap_deviation_samples));
  CHECK(made.attack_samples == doctest::Approx(high.attack_samples));
  CHECK(made.attack_bend == doctest::Approx(high.attack_bend));
  CHECK(made.decay == doctest::Approx(high.decay));
  CHECK(made.mean_amplitude == doctest::Approx(low.mean_amplitude * std::sqrt(96000.0 / 44100.0)));
  CHECK(made.gap_correlation == low.gap_correlation);
  REQUIRE(made.clicks.size() == high.clicks.size());
  for (std::size_t i = 0; i < made.clicks.size(); ++i) {
    double product = 0, energy = 0;  // correlation with the same damped sine computed at 96 kHz
    const auto& m = made.clicks[i];
    for (std::size_t k = 0; k < m.size(); ++k) {
      energy += static_cast<double>(m[k]) * m[k];
      if (k < high.clicks[i].size()) product += static_cast<double>(m[k]) * high.clicks[i][k];
    }
    CHECK(energy == doctest::Approx(1).epsilon(1e-5));
    CHECK(product > 0.9999);
  }
}
