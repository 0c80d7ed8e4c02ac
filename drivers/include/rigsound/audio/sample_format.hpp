// The sample formats of cards and files, and the one conversion into them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rigsound/audio/audio_options.hpp"

namespace rigsound::audio {

std::string_view name(SampleFormat format);  ///< "auto", "FLOAT", "S32", "S24_3", "S16"
std::optional<SampleFormat> sample_format_by_name(std::string_view text);
std::size_t bytes_per_sample(SampleFormat format);  ///< kAuto counts as float

/// Converts `count` samples, full scale 1, clipped. S16 gets triangular dither of +-1 LSB that depends on
/// nothing but the position of the sample (`first_sample` + i), so that a card and a file rendered from
/// the same blocks hold the same bits; a sample of exactly 0 stays 0. `out`: count x bytes_per_sample.
/// Thread: RT.
void convert(const float* in, std::size_t count, std::uint64_t first_sample, SampleFormat format,
             void* out) noexcept;

}  // namespace rigsound::audio
