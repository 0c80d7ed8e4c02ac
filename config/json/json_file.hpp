// A JSON file of checked values, with line numbers for messages.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/machine/fields.hpp"

namespace rigsound::config {

/// Keys are those of the top object, or of the object inside it that object() and objects() give: those share
/// the file's one text and tree. Every getter throws InputError `FILE:LINE: KEY: is X, expected Y` when the
/// key is missing, of another type, not finite or out of range.
class JsonFile {
 public:
  /// Errors: InputError, also for more than 32 levels of brackets.
  explicit JsonFile(const std::filesystem::path& file);

  bool has(std::string_view key) const;
  std::vector<std::string> keys() const;

  double number(std::string_view key, const Range& range) const;
  bool flag(std::string_view key) const;
  std::string text(std::string_view key) const;
  std::vector<float> floats(std::string_view key, const Range& range) const;
  /// [[b, c], ...], at most `most` of them.
  std::vector<std::array<double, 2>> pairs(std::string_view key, const Range& range, std::size_t most) const;
  JsonFile object(std::string_view key) const;                ///< the object under `key`
  std::vector<JsonFile> objects(std::string_view key) const;  ///< the list of objects under `key`

  /// Refuses a file whose `format` is not the one this program writes.
  void require_format(int format) const;

  [[noreturn]] void fail(std::string_view key, std::string_view problem) const;
  /// For what a check found: error.key() is a path from here, "points[1].rho".
  [[noreturn]] void fail(const InvalidField& error) const;

 private:
  struct Document;
  JsonFile(const JsonFile& outer, const nlohmann::json& item, const std::string& path, std::size_t position);
  const nlohmann::json& value(std::string_view key) const;
  void require_at_most(std::size_t most, std::string_view key, const nlohmann::json& list,
                       std::string_view what) const;
  [[noreturn]] void fail_kind(std::string_view key, const nlohmann::json& found,
                              std::string_view expected) const;
  double checked(std::string_view key, const nlohmann::json& value, const Range& range) const;
  std::size_t position_of(std::string_view key) const;

  std::shared_ptr<const Document> document_;
  const nlohmann::json* node_;
  std::string path_;      // of the object in the file, such as "points[1]."
  std::size_t position_;  // of its { in the text
};

}  // namespace rigsound::config
