#include "access.hpp"

#include <nettle/memops.h>
#include <sys/random.h>

#include <array>
#include <string_view>

#include "http.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::studio {
namespace {

constexpr std::string_view kApi = "/api/";

/// Takes as long for a wrong first letter as for a wrong last one.
bool same(const std::string& a, const std::string& b) {
  return a.size() == b.size() && memeql_sec(a.data(), b.data(), a.size()) != 0;
}

bool starts_with(const std::string& text, std::string_view start) {
  return text.compare(0, start.size(), start) == 0;
}

}  // namespace

bool Access::is_here(const std::string& authority) const {
  const std::string port = ":" + std::to_string(port_);
  return authority == "127.0.0.1" + port || authority == "localhost" + port;
}

std::optional<Refusal> Access::refusal(const Origin& from) const {
  if (!is_here(from.host)) return Refusal{403, "Host: is not this server"};
  constexpr std::string_view kScheme = "http://";
  if (!from.origin.empty() &&
      !(starts_with(from.origin, kScheme) && is_here(from.origin.substr(kScheme.size()))))
    return Refusal{403, "Origin: is another page"};
  const bool reads = from.method == "GET" || from.method == "HEAD";
  if (!reads && from.method != "PUT" && from.method != "POST" && from.method != "DELETE")
    return Refusal{405, from.method + ": expected GET, PUT, POST or DELETE"};
  if (!reads && !from.fetch_site.empty() && from.fetch_site != "same-origin" && from.fetch_site != "none")
    return Refusal{403, "Sec-Fetch-Site: is another page"};
  if (!starts_with(from.path, kApi))
    return reads ? std::nullopt : std::optional<Refusal>({405, "pages are only read"});
  if (!same(from.token, token_)) return Refusal{401, "X-Rigsound-Token: is missing or wrong"};
  if (!from.transfer_encoding.empty()) return Refusal{411, "Content-Length: is missing"};
  if (!from.content_encoding.empty()) return Refusal{415, "Content-Encoding: expected none"};
  if (from.content_length > 0 && !starts_with(from.content_type, "application/json"))
    return Refusal{415, "Content-Type: expected application/json"};
  const std::size_t most = from.path == "/api/v1/listen/results" ? kMostResultBytes : kMostBodyBytes;
  if (from.content_length > most)
    return Refusal{413, "body: expected at most " + std::to_string(most) + " bytes"};
  return std::nullopt;
}

std::string new_token() {
  std::array<unsigned char, 16> bits{};
  if (::getrandom(bits.data(), bits.size(), 0) != static_cast<ssize_t>(bits.size()))
    throw DeviceError("no random numbers for a token");
  std::string token;
  for (const unsigned char byte : bits) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

}  // namespace rigsound::studio
