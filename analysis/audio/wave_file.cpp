#include "rigsound/analysis/wave_file.hpp"

#include "rigsound/audio/sound_writer.hpp"

namespace rigsound::analysis {

std::uint64_t write_wave(const AtomicFile& file, const std::vector<float>& mono, int rate) {
  audio::SoundWriter writer(file, {rate, 1});
  writer.write(mono.data(), mono.size() * sizeof(float));
  writer.close();
  return writer.clipped();
}

std::uint64_t write_wave(const std::filesystem::path& path, const std::vector<float>& mono, int rate) {
  AtomicFile file(path);
  const std::uint64_t clipped = write_wave(file, mono, rate);
  file.commit();
  return clipped;
}

std::uint64_t write_wave(const std::filesystem::path& path, const std::vector<double>& mono, int rate) {
  return write_wave(path, std::vector<float>(mono.begin(), mono.end()), rate);
}

}  // namespace rigsound::analysis
