// Text of older tools as UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace rigsound::config {

/// `text` as it is when it is valid UTF-8, else read as Windows-1252.
std::string to_utf8(std::string_view text);

}  // namespace rigsound::config
