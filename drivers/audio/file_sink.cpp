#include "rigsound/audio/file_sink.hpp"

#include <algorithm>
#include <utility>

#include "rigsound/audio/sample_format.hpp"

namespace rigsound::audio {

FileSink::FileSink(const std::filesystem::path& file, const Format& format, Tap tap)
    : format_(format),
      tap_(std::move(tap)),
      bytes_(format.block * format.channels * bytes_per_sample(format.samples)),
      file_(file),
      writer_(file_, format) {}

void FileSink::write(const float* block, std::uint64_t number) {
  const std::size_t samples = format_.block * format_.channels;
  convert(block, samples, number * samples, format_.samples, bytes_.data());
  append();
}

void FileSink::skip(std::uint64_t blocks) {
  std::fill(bytes_.begin(), bytes_.end(), static_cast<unsigned char>(0));  // silence in every format
  for (std::uint64_t i = 0; i < blocks; ++i) append();
}

void FileSink::append() {
  writer_.write(bytes_.data(), bytes_.size());
  if (tap_) tap_(bytes_.data(), bytes_.size());
}

void FileSink::commit() {
  writer_.close();
  file_.commit();
}

}  // namespace rigsound::audio
