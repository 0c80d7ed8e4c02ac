// Pictures as PNG.
#pragma once

#include <filesystem>
#include <string>

#include "chart/canvas.hpp"

namespace rigsound::chart {

/// The bytes of the file. Thread: any.
std::string png_bytes(const Picture& picture);

/// As a data URI for SVG. Thread: OFF.
std::string png_data_uri(const Picture& picture);

/// Writes `pixels` row by row from the top, `width` to a row. Errors: DeviceError. Thread: OFF.
void write_png(const std::filesystem::path& file, const std::vector<Colour>& pixels, int width);

}  // namespace rigsound::chart
