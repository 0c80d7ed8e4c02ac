// Who may ask: the page that this server itself handed out, and nobody else. Thread: any.
#pragma once

#include <optional>
#include <string>

namespace rigsound::studio {

/// What a request says of where it comes from; empty: nothing.
struct Origin {
  std::string method, path, host, origin, fetch_site, token;
  std::string content_type, content_encoding, transfer_encoding;
  std::size_t content_length = 0;
};

struct Refusal {
  int status;
  std::string line;
};

class Access {
 public:
  explicit Access(std::string token) : token_(std::move(token)) {}

  void set_port(int port) { port_ = port; }
  const std::string& token() const { return token_; }

  /// Nothing when it may pass. Looked at before the body is read.
  std::optional<Refusal> refusal(const Origin& from) const;

 private:
  bool is_here(const std::string& authority) const;

  std::string token_;
  int port_ = 0;
};

/// 128 random bits, 32 hex digits. Errors: DeviceError when the machine has none.
std::string new_token();

}  // namespace rigsound::studio
