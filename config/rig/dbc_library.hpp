// The DBC files of one bus.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rigsound/config/dbc.hpp"

namespace rigsound::config {

/// Thread: OFF.
class DbcLibrary {
 public:
  struct Entry {
    const std::string* file;
    const DbcMessage* message;
    const DbcSignal* signal;
  };

  /// Errors: InputError for a file that cannot be read or holds no message.
  void add(const std::filesystem::path& file);

  /// The signal of that message, by short or long names. Two files may say the same of it. Nothing when it is
  /// nowhere, cannot be read, or when two files differ: then `problem` says what is wrong and what was
  /// expected.
  std::optional<Entry> find(const std::string& message, const std::string& signal,
                            std::string& problem) const;

 private:
  struct File {
    std::string name;
    Dbc dbc;
  };
  std::string no_message(const std::string& message) const;

  std::deque<File> files_;
};

}  // namespace rigsound::config
