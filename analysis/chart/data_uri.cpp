#include "rigsound/analysis/data_uri.hpp"

#include <openssl/evp.h>

namespace rigsound::chart {

std::string data_uri(const char* type, std::string_view bytes) {
  std::string base64((bytes.size() + 2) / 3 * 4 + 1, '\0');  // the encoder ends with a zero
  base64.resize(static_cast<std::size_t>(EVP_EncodeBlock(reinterpret_cast<unsigned char*>(base64.data()),
                                                         reinterpret_cast<const unsigned char*>(bytes.data()),
                                                         static_cast<int>(bytes.size()))));
  return std::string("data:") + type + ";base64," + base64;
}

}  // namespace rigsound::chart
