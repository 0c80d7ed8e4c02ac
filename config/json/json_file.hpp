// A JSON file of checked values, with line numbers for messages.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rigsound::config {

/// Keys are those of the top object. Every getter throws InputError `FILE:LINE: KEY: ...` when the key is
/// missing, of another type, not finite or out of range.
class JsonFile {
 public:
  explicit JsonFile(const std::filesystem::path& file);

  double number(std::string_view key, double min, double max) const;
  int integer(std::string_view key, int min, int max) const;
  std::string text(std::string_view key) const;
  std::vector<float> floats(std::string_view key, double min, double max) const;
  const nlohmann::json& value(std::string_view key) const;

  /// Refuses a file whose `format` is not the one this program writes.
  void require_format(int format) const;

  [[noreturn]] void fail(std::string_view key, std::string_view message) const;

 private:
  int line_of(std::string_view key) const;

  std::string file_, text_;
  nlohmann::json root_;
};

}  // namespace rigsound::config
