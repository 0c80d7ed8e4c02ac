// An image of 16 colours as a PNG in a data URI.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rigsound::analysis {

struct Colour {
  std::uint8_t red, green, blue;
};

/// `pixels` row by row from the top, `width` to a row, values 0...15 into `palette`. Thread: OFF.
std::string png_data_uri(const std::vector<std::uint8_t>& pixels, int width,
                         const std::array<Colour, 16>& palette);

}  // namespace rigsound::analysis
