// The one way a room says that what it was given is wrong.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace rigsound {

/// Input or configuration that cannot be used. what() is the one line a user sees:
/// `FILE:LINE: KEY: what is wrong, what was expected` (LINE and KEY are left out when there are none).
/// Programs end with exit code 1. Thread: OFF, CT.
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view file, int line, std::string_view key, std::string_view message)
      : std::runtime_error(compose(file, line, key, message)) {}
  InputError(std::string_view file, std::string_view message) : InputError(file, 0, {}, message) {}

 private:
  static std::string compose(std::string_view file, int line, std::string_view key,
                             std::string_view message) {
    std::string text(file);
    if (line > 0) text += ":" + std::to_string(line);
    if (!key.empty()) text.append(": ").append(key);
    return text.append(": ").append(message);
  }
};

}  // namespace rigsound
