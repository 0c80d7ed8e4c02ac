// Bytes inside a page.
#pragma once

#include <string>
#include <string_view>

namespace rigsound::chart {

/// "data:TYPE;base64,...", of a MIME type. Thread: OFF.
std::string data_uri(const char* type, std::string_view bytes);

}  // namespace rigsound::chart
