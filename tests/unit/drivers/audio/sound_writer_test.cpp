// A WAV file that grows over what its sizes can say goes on as RF64, with every sample.
#include "rigsound/audio/sound_writer.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "rigsound/audio/sample_format.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::audio;
using namespace rigsound::test;

namespace {

struct WrittenSound {
  SF_INFO info{};
  std::vector<float> samples;
};

WrittenSound written(const std::filesystem::path& file) {
  WrittenSound result;
  SNDFILE* const sound = sf_open(file.c_str(), SFM_READ, &result.info);
  REQUIRE(sound != nullptr);
  result.samples.resize(static_cast<std::size_t>(result.info.frames * result.info.channels));
  CHECK(sf_read_float(sound, result.samples.data(), static_cast<sf_count_t>(result.samples.size())) ==
        static_cast<sf_count_t>(result.samples.size()));
  sf_close(sound);
  return result;
}

std::vector<float> sound_of(std::size_t samples) {
  std::vector<float> sound(samples);
  for (std::size_t i = 0; i < samples; ++i) sound[i] = static_cast<float>(i % 1000) / 1024;
  return sound;
}

/// Writes `sound` in blocks of 96 samples.
void write(const std::filesystem::path& file, const SoundFormat& format, const std::vector<float>& sound,
           std::uint64_t most_wav_bytes) {
  AtomicFile target(file);
  SoundWriter writer(target, format, most_wav_bytes);
  std::vector<unsigned char> bytes(96 * bytes_per_sample(format.samples));
  for (std::size_t at = 0; at < sound.size(); at += 96) {
    convert(sound.data() + at, 96, at, format.samples, bytes.data());
    writer.write(bytes.data(), bytes.size());
  }
  writer.close();
  target.commit();
}

}  // namespace

TEST_CASE("A WAV file over its limit is RF64 from then on and holds every sample; under it, it is a WAV") {
  const TemporaryFolder folder;
  for (const SampleFormat samples : {SampleFormat::kFloat, SampleFormat::kS16, SampleFormat::kS24_3})
    for (const int channels : {1, 2, 6}) {
      CAPTURE(channels);
      const std::vector<float> sound = sound_of(96 * 20'000);
      const std::uint64_t whole = sound.size() * bytes_per_sample(samples);
      const SoundFormat format{48000, channels, samples};
      write(folder.path / "wav.wav", format, sound, whole);
      write(folder.path / "rf64.wav", format, sound, whole - 100'000);
      const WrittenSound wav = written(folder.path / "wav.wav"), rf64 = written(folder.path / "rf64.wav");
      CHECK(content(folder.path / "wav.wav").substr(0, 4) == "RIFF");
      CHECK(content(folder.path / "rf64.wav").substr(0, 4) == "RF64");
      CHECK(content(folder.path / "rf64.wav").substr(0, 512).find("PEAK") == std::string::npos);
      CHECK((rf64.info.format & SF_FORMAT_SUBMASK) == (wav.info.format & SF_FORMAT_SUBMASK));
      CHECK(rf64.info.channels == channels);
      CHECK(rf64.samples.size() == sound.size());
      CHECK(rf64.samples == wav.samples);
    }
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 2);
}

TEST_CASE("FLAC and Ogg hold as many frames as were written, in blocks of any size") {
  const TemporaryFolder folder;
  for (const char* name : {"a.ogg", "a.flac"})
    for (const int channels : {1, 2})
      for (const std::size_t frames :
           {std::size_t{1}, std::size_t{4096}, std::size_t{5000}, std::size_t{9000}}) {
        CAPTURE(name);
        CAPTURE(frames);
        const std::vector<float> sound = sound_of(frames * static_cast<std::size_t>(channels));
        AtomicFile target(folder.path / name);
        SoundWriter writer(target, {48000, channels, SampleFormat::kFloat}, 1 << 30);
        writer.write(sound.data(), sound.size() * sizeof(float));
        writer.write(sound.data(), sound.size() * sizeof(float));
        writer.close();
        target.commit();
        const WrittenSound read = written(folder.path / name);
        CHECK(read.info.channels == channels);
        CHECK(read.samples.size() == 2 * sound.size());
        if (std::string(name) == "a.flac")
          for (std::size_t i = 0; i < read.samples.size(); ++i)
            REQUIRE(std::fabs(read.samples[i] - sound[i % sound.size()]) < 1e-6F);
      }
}

TEST_CASE("Samples are kept as asked for, in FLAC with 16 bits or 24, in Ogg as Vorbis") {
  const TemporaryFolder folder;
  const auto kept = [&](const char* name, SampleFormat samples) {
    write(folder.path / name, {48000, 1, samples}, sound_of(9600), 1 << 30);
    return written(folder.path / name).info.format & SF_FORMAT_SUBMASK;
  };
  CHECK(kept("a.wav", SampleFormat::kS16) == SF_FORMAT_PCM_16);
  CHECK(kept("b.wav", SampleFormat::kS24_3) == SF_FORMAT_PCM_24);
  CHECK(kept("c.wav", SampleFormat::kS32) == SF_FORMAT_PCM_32);
  CHECK(kept("d.wav", SampleFormat::kFloat) == SF_FORMAT_FLOAT);
  CHECK(kept("a.flac", SampleFormat::kS16) == SF_FORMAT_PCM_16);
  CHECK(kept("b.flac", SampleFormat::kS24_3) == SF_FORMAT_PCM_24);
  CHECK(kept("c.flac", SampleFormat::kFloat) == SF_FORMAT_PCM_24);
  CHECK(kept("a.ogg", SampleFormat::kFloat) == SF_FORMAT_VORBIS);
}
