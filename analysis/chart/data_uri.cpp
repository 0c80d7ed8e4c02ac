#include "rigsound/analysis/data_uri.hpp"

#include <nettle/base64.h>

namespace rigsound::chart {

std::string data_uri(const char* type, std::string_view bytes) {
  std::string base64(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(base64.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return std::string("data:") + type + ";base64," + base64;
}

}  // namespace rigsound::chart
