#include "rigsound/analysis/samples.hpp"

#include <utility>

namespace rigsound::analysis {

Samples::Samples(std::vector<float> in_memory)
    : memory_(std::make_shared<const std::vector<float>>(std::move(in_memory))), size_(memory_->size()) {}

std::vector<float> Samples::piece(std::size_t begin, std::size_t end) const {
  if (memory_)
    return {memory_->begin() + static_cast<std::ptrdiff_t>(begin),
            memory_->begin() + static_cast<std::ptrdiff_t>(end)};
  std::vector<float> sound(end - begin);
  if (file_) file_->read(at_ + begin * sizeof(float), sound.data(), sound.size() * sizeof(float));
  return sound;
}

Samples SampleFile::keep(const std::vector<float>& sound) {
  Samples kept;
  add(sound, kept);
  return kept;
}

void SampleFile::add(const std::vector<float>& piece, Samples& sound) {
  const std::uint64_t at = file_->append(piece.data(), piece.size() * sizeof(float));
  if (!sound.file_) sound.file_ = file_, sound.at_ = at;
  sound.size_ += piece.size();
}

}  // namespace rigsound::analysis
