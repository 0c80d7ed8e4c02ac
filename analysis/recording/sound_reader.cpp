#include "rigsound/analysis/sound_reader.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "recording/mean_channel.hpp"
#include "recording/open_sound.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {

struct SoundReader::Parts {
  SF_INFO info{};
  OpenSound sound;

  explicit Parts(const std::filesystem::path& file) : sound(file, info) {}
};

SoundReader::SoundReader(const std::filesystem::path& file) : parts_(std::make_unique<Parts>(file)) {
  if (!parts_->sound.get())
    throw InputError(file.string(), std::string("is no sound file: ") + sf_strerror(nullptr));
  const SF_INFO& info = parts_->info;
  if (info.frames <= 0) throw InputError(file.string(), "holds no sample");
  shape_ = {static_cast<long>(info.frames), info.samplerate, info.channels};
}

SoundReader::~SoundReader() = default;
SoundReader::SoundReader(SoundReader&&) noexcept = default;

void SoundReader::read(long from, std::size_t count, float* to) {
  const long end = std::min(from + static_cast<long>(count), shape_.frames), begin = std::max(from, 0L);
  std::fill(to, to + count, 0.0F);
  if (begin >= end) return;
  SNDFILE* const sound = parts_->sound.get();
  if (at_ != begin && sf_seek(sound, begin, SEEK_SET) != begin) return;
  float* const first = to + (begin - from);
  const std::size_t got = read_mean(sound, shape_.channels, first, static_cast<std::size_t>(end - begin));
  at_ = begin + static_cast<long>(got);
  for (std::size_t n = 0; n < got; ++n)
    if (!std::isfinite(first[n])) first[n] = 0;
}

std::vector<float> SoundReader::read(long from, std::size_t count) {
  std::vector<float> mono(count);
  read(from, count, mono.data());
  return mono;
}

}  // namespace rigsound::analysis
