#include "recording/mean_channel.hpp"

#include <algorithm>
#include <vector>

namespace rigsound::analysis {

std::size_t read_mean(SNDFILE* sound, int channels, float* to, std::size_t count) {
  constexpr std::size_t kBlock = 1 << 14;
  const auto wide = static_cast<std::size_t>(channels);
  std::vector<float> block(wide > 1 ? kBlock * wide : 0);
  std::size_t done = 0;
  while (done < count) {
    const std::size_t wanted = std::min(kBlock, count - done);
    float* const read = wide > 1 ? block.data() : to + done;
    const sf_count_t got = sf_readf_float(sound, read, static_cast<sf_count_t>(wanted));
    if (got <= 0) break;
    for (std::size_t n = 0; wide > 1 && n < static_cast<std::size_t>(got); ++n) {
      float sum = 0;
      for (std::size_t c = 0; c < wide; ++c) sum += block[n * wide + c];
      to[done + n] = sum / static_cast<float>(channels);
    }
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace rigsound::analysis
