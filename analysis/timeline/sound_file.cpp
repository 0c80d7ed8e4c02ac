#include "timeline/sound_file.hpp"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {

SoundFile read_sound(const std::filesystem::path& file, const Progress& progress) {
  constexpr sf_count_t kFramesAtOnce = 65536;
  const InputFile input(file, "sound file");
  SF_INFO format{};
  const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> in(sf_open(input.path().c_str(), SFM_READ, &format),
                                                       sf_close);
  if (!in) throw InputError(input.name(), std::string("cannot be read: ") + sf_strerror(nullptr));
  SoundFile sound{{}, format.samplerate, format.channels, 0};
  std::vector<float> frames(static_cast<std::size_t>(kFramesAtOnce * format.channels));
  for (sf_count_t got; (got = sf_readf_float(in.get(), frames.data(), kFramesAtOnce)) > 0;) {
    show(progress, sound.mono.size(), format.frames);
    for (sf_count_t n = 0; n < got; ++n) {
      double sum = 0;
      for (int c = 0; c < format.channels; ++c) {
        const double x = static_cast<double>(frames[static_cast<std::size_t>(n * format.channels + c)]);
        sum += x;
        sound.peak = std::max(sound.peak, std::fabs(x));
      }
      if (!std::isfinite(sum)) throw InputError(input.name(), "holds a sample that is not finite");
      sound.mono.push_back(static_cast<float>(sum / format.channels));
    }
  }
  if (sound.mono.empty()) throw InputError(input.name(), "holds no sample");
  return sound;
}

}  // namespace rigsound::analysis
