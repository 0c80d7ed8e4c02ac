// A JSON file of checked values, with line numbers for messages.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rigsound::config {

/// Keys are those of the top object, or of the object inside it that object() and objects() give. Every
/// getter throws InputError `FILE:LINE: KEY: ...` when the key is missing, of another type, not finite or out
/// of range.
class JsonFile {
 public:
  explicit JsonFile(const std::filesystem::path& file);

  double number(std::string_view key, double min, double max) const;
  int integer(std::string_view key, int min, int max) const;
  std::string text(std::string_view key) const;
  std::vector<float> floats(std::string_view key, double min, double max) const;
  const nlohmann::json& value(std::string_view key) const;
  const nlohmann::json& root() const { return root_; }        ///< the object whose keys these are
  JsonFile object(std::string_view key) const;                ///< the object under `key`
  std::vector<JsonFile> objects(std::string_view key) const;  ///< the list of objects under `key`

  /// Refuses a file whose `format` is not the one this program writes.
  void require_format(int format) const;

  [[noreturn]] void fail(std::string_view key, std::string_view message) const;

 private:
  JsonFile inside(std::string_view path, const nlohmann::json& item) const;
  int line_of(std::string_view key) const;

  std::string file_, text_;
  std::string path_;  // of the object in the file, such as "points[1]."
  nlohmann::json root_;
};

}  // namespace rigsound::config
