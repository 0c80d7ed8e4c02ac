#include "sound_set/clicks_wav.hpp"

#include <sndfile.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>

#include "rigsound/config/bank_files.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/input_error.hpp"

namespace rigsound::config {
namespace {

using Cues = SF_CUES_VAR(kMaxBankClicks);
using Sound = std::unique_ptr<SNDFILE, int (*)(SNDFILE*)>;

constexpr double kUnitTolerance = 1e-5;  // float rounding of a long click stays below

std::unique_ptr<Cues> cues_of(const Clicks& clicks) {
  auto cues = std::make_unique<Cues>();
  std::uint32_t start = 0;
  for (const std::vector<float>& click : clicks) {
    SF_CUE_POINT& cue = cues->cue_points[cues->cue_count++];
    cue.indx = static_cast<std::int32_t>(cues->cue_count);
    cue.position = cue.sample_offset = start;
    cue.fcc_chunk = 0x61746164;  // "data"
    start += static_cast<std::uint32_t>(click.size());
  }
  return cues;
}

/// libsndfile reads what there is of a file that was cut off and says nothing.
void require_whole(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  unsigned char head[8] = {};
  in.read(reinterpret_cast<char*>(head), sizeof head);
  if (!in || std::string(head, head + 4) != "RIFF") return;
  const std::uint64_t announced =
      8 + (head[4] | head[5] << 8 | head[6] << 16 | static_cast<std::uint64_t>(head[7]) << 24);
  std::error_code error;
  const std::uint64_t there = std::filesystem::file_size(file, error);
  if (there < announced)
    throw InputError(file.string(), "is cut off after " + std::to_string(there) + " bytes, expected " +
                                        std::to_string(announced));
}

std::vector<float> unit_click(std::vector<float> click, const std::string& file, std::size_t index) {
  double energy = 0;
  for (const float x : click) energy += static_cast<double>(x) * x;
  const std::string which = "click " + std::to_string(index + 1);
  if (!std::isfinite(energy)) throw InputError(file, which + " has samples that are not finite numbers");
  if (energy < 1e-20) throw InputError(file, which + " is silent, expected a sound at every cue point");
  const double norm = std::sqrt(energy);
  if (std::fabs(norm - 1) > kUnitTolerance)
    for (float& x : click) x = static_cast<float>(x / norm);
  return click;
}

}  // namespace

void write_clicks_wav(const std::filesystem::path& file, const Clicks& clicks, int sample_rate) {
  SF_INFO format{};
  format.samplerate = sample_rate;
  format.channels = 1;
  format.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  const Sound sound(sf_open(file.c_str(), SFM_WRITE, &format), sf_close);
  if (!sound) throw DeviceError(file.string() + ": cannot be written: " + sf_strerror(nullptr));
  sf_command(sound.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);  // it carries the time of writing
  const auto cues = cues_of(clicks);
  bool whole = sf_command(sound.get(), SFC_SET_CUE, cues.get(), sizeof(Cues)) == SF_TRUE;
  for (const std::vector<float>& click : clicks) {
    const auto size = static_cast<sf_count_t>(click.size());
    whole = whole && sf_write_float(sound.get(), click.data(), size) == size;
  }
  if (!whole) throw DeviceError(file.string() + ": cannot be written whole: " + sf_strerror(sound.get()));
}

Clicks read_clicks_wav(const std::filesystem::path& file, int sample_rate) {
  const std::string name = file.string();
  SF_INFO format{};
  const Sound sound(sf_open(file.c_str(), SFM_READ, &format), sf_close);
  if (!sound)
    throw InputError(
        name, std::string("cannot be read as a WAV file, expected the clicks: ") + sf_strerror(nullptr));
  require_whole(file);
  if (format.channels != 1) throw InputError(name, std::to_string(format.channels) + " channels, expected 1");
  if (format.samplerate != sample_rate)
    throw InputError(name, std::to_string(format.samplerate) +
                               " Hz, expected the sample_rate of bank.json, " + std::to_string(sample_rate) +
                               " Hz");
  auto cues = std::make_unique<Cues>();
  if (sf_command(sound.get(), SFC_GET_CUE, cues.get(), sizeof(Cues)) != SF_TRUE || cues->cue_count == 0)
    throw InputError(name, "has no cue points, expected one at the start of each click");

  Clicks clicks;
  sf_count_t at = 0;
  for (std::uint32_t i = 0; i < cues->cue_count; ++i) {
    const bool last = i + 1 == cues->cue_count;
    const sf_count_t start = cues->cue_points[i].sample_offset;
    const sf_count_t end =
        last ? format.frames : static_cast<sf_count_t>(cues->cue_points[i + 1].sample_offset);
    if (start < at || end <= start || end > format.frames)
      throw InputError(name, "cue point " + std::to_string(i + 1) + " at sample " + std::to_string(start) +
                                 " is out of order or behind the end, expected ascending starts of clicks");
    std::vector<float> click(static_cast<std::size_t>(end - start));
    sf_seek(sound.get(), start, SEEK_SET);
    if (sf_read_float(sound.get(), click.data(), end - start) != end - start)
      throw InputError(name, "ends before its last click");
    clicks.push_back(unit_click(std::move(click), name, i));
    at = end;
  }
  return clicks;
}

}  // namespace rigsound::config
