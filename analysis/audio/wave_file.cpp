#include "rigsound/analysis/wave_file.hpp"

#include <sndfile.h>

#include "rigsound/device_error.hpp"

namespace rigsound::analysis {

void write_wave(const AtomicFile& file, const std::vector<float>& mono, int rate) {
  const std::string path = file.target().string();
  SF_INFO info{};
  info.samplerate = rate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* sound = sf_open(file.temporary().c_str(), SFM_WRITE, &info);
  if (!sound) throw DeviceError(path + ": cannot be written: " + sf_strerror(nullptr));
  // The peak chunk holds a time stamp: without it equal samples give equal files.
  sf_command(sound, SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
  const auto frames = static_cast<sf_count_t>(mono.size());
  const bool whole = sf_writef_float(sound, mono.data(), frames) == frames;
  const bool closed = sf_close(sound) == 0;
  if (!whole || !closed) throw DeviceError(path + ": cannot be written: disk full?");
}

void write_wave(const std::filesystem::path& path, const std::vector<float>& mono, int rate) {
  AtomicFile file(path);
  write_wave(file, mono, rate);
  file.commit();
}

void write_wave(const std::filesystem::path& path, const std::vector<double>& mono, int rate) {
  write_wave(path, std::vector<float>(mono.begin(), mono.end()), rate);
}

}  // namespace rigsound::analysis
