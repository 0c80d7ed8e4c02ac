#include "sound_set/clicks_wav.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "rigsound/config/bank_files.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/dsp/energy.hpp"
#include "rigsound/machine/input_error.hpp"
#include "sound_set/wav_sound.hpp"

namespace rigsound::config {
namespace {

using Cues = SF_CUES_VAR(kMaxBankClicks);

std::unique_ptr<Cues> cues_of(const Clicks& clicks) {
  auto cues = std::make_unique<Cues>();
  std::uint32_t start = 0;
  for (const Click& click : clicks) {
    SF_CUE_POINT& cue = cues->cue_points[cues->cue_count++];
    cue.indx = static_cast<std::int32_t>(cues->cue_count);
    cue.position = cue.sample_offset = start;
    cue.fcc_chunk = 0x61746164;  // "data"
    start += static_cast<std::uint32_t>(click.size());
  }
  return cues;
}

void make_unit(float* click, std::size_t samples, const std::string& file, std::size_t index) {
  const double energy = dsp::energy(click, samples);
  const std::string which = "click " + std::to_string(index + 1);
  if (!std::isfinite(energy)) throw InputError(file, which + " has samples that are not finite numbers");
  if (energy < 1e-20) throw InputError(file, which + " is silent, expected a sound at every cue point");
  const double norm = std::sqrt(energy);
  if (std::fabs(norm - 1) > kUnitNormTolerance) dsp::divide(click, samples, norm);
}

/// Where each click starts: one or more, ascending, before `frames`.
std::vector<sf_count_t> starts_of(const Cues& cues, sf_count_t frames, const std::string& file) {
  std::vector<sf_count_t> starts;
  for (std::uint32_t i = 0; i < cues.cue_count; ++i) {
    const bool last = i + 1 == cues.cue_count;
    const sf_count_t start = cues.cue_points[i].sample_offset;
    const sf_count_t end = last ? frames : static_cast<sf_count_t>(cues.cue_points[i + 1].sample_offset);
    if (end <= start || end > frames)
      throw InputError(file, "cue point " + std::to_string(i + 1) + " at sample " + std::to_string(start) +
                                 " is out of order or behind the end, expected ascending starts of clicks");
    starts.push_back(start);
  }
  return starts;
}

}  // namespace

void write_clicks_wav(const std::filesystem::path& file, const Clicks& clicks, int sample_rate) {
  const WavSound sound = create_wav(file, sample_rate);
  const auto cues = cues_of(clicks);
  if (sf_command(sound.get(), SFC_SET_CUE, cues.get(), sizeof(Cues)) != SF_TRUE)
    throw DeviceError(file.string() + ": cannot be written whole: " + sf_strerror(sound.get()));
  for (const Click& click : clicks) write_samples(sound, file, click.data(), click.size());
}

Clicks read_clicks_wav(const std::filesystem::path& file, int sample_rate, ClickStore& store) {
  const std::string name = file.string();
  const WavReader wav(file);
  const SF_INFO& format = wav.format();
  if (format.samplerate != sample_rate)
    throw InputError(name, std::to_string(format.samplerate) +
                               " Hz, expected the sample_rate of bank.json, " + std::to_string(sample_rate) +
                               " Hz");
  const std::unique_ptr<Cues> cues(new Cues);  // as large as the largest bank: only what it holds is touched
  if (sf_command(wav.get(), SFC_GET_CUE, cues.get(), sizeof(Cues)) != SF_TRUE || cues->cue_count == 0)
    throw InputError(name, "has no cue points, expected one at the start of each click");

  std::vector<sf_count_t> starts = starts_of(*cues, format.frames, name);
  const sf_count_t first = starts.front();
  const std::shared_ptr<float> samples = store.room(static_cast<std::size_t>(format.frames - first));
  wav.read(first, format.frames - first, samples.get());
  starts.push_back(format.frames);
  Clicks clicks;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    const std::shared_ptr<float> click(samples, samples.get() + (starts[i] - first));
    const auto length = static_cast<std::size_t>(starts[i + 1] - starts[i]);
    make_unit(click.get(), length, name, i);
    clicks.emplace_back(click, length);
  }
  return clicks;
}

}  // namespace rigsound::config
