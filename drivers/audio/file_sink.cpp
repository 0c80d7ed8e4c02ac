#include "rigsound/audio/file_sink.hpp"

#include <algorithm>
#include <utility>

#include "rigsound/audio/sample_format.hpp"

namespace rigsound::audio {
namespace {

constexpr std::size_t kWrittenAtOnce = 1 << 16;  // bytes: a call of the kernel costs as much as a block

std::size_t size_of_block(const FileSink::Format& format) {
  return static_cast<std::size_t>(format.block) * static_cast<std::size_t>(format.channels) *
         bytes_per_sample(format.samples);
}

std::size_t whole_blocks(std::size_t block_bytes) {
  return block_bytes * std::max<std::size_t>(1, kWrittenAtOnce / block_bytes);
}

}  // namespace

FileSink::FileSink(const std::filesystem::path& file, const Format& format, Tap tap)
    : format_(format),
      tap_(std::move(tap)),
      block_bytes_(size_of_block(format)),
      bytes_(whole_blocks(block_bytes_)),
      file_(file),
      writer_(file_, format) {}

void FileSink::write(const float* block, std::uint64_t number) {
  const std::size_t samples = format_.block * format_.channels;
  convert(block, samples, number * samples, format_.samples, &bytes_[held_]);
  advance();
}

void FileSink::skip(std::uint64_t blocks) {
  for (std::uint64_t i = 0; i < blocks; ++i) {
    std::fill_n(&bytes_[held_], block_bytes_, static_cast<unsigned char>(0));  // silence in every format
    advance();
  }
}

void FileSink::advance() {
  held_ += block_bytes_;
  if (held_ == bytes_.size()) write_held();
}

void FileSink::write_held() {
  if (held_ == 0) return;
  writer_.write(bytes_.data(), held_);
  if (tap_) tap_(bytes_.data(), held_);
  held_ = 0;
}

void FileSink::commit() {
  write_held();
  writer_.close();
  file_.commit();
}

}  // namespace rigsound::audio
