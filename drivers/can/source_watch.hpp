// Which J1939 sources send what a rig takes from any.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/can/frame.hpp"

namespace rigsound::can {

/// Two engines on one bus take turns in one signal: worth a word. Thread: one at a time.
class SourceWatch {
 public:
  explicit SourceWatch(const std::vector<SignalRoute>& routes);

  /// The word, when this frame's source is the second of its message.
  std::optional<std::string> add(const Frame& frame);

  /// A word on every message that came from several sources.
  std::vector<std::string> found() const;

 private:
  /// A message without a chosen source.
  struct Message {
    std::string name;
    MessageMatch match;
    std::set<std::uint8_t> sources;
  };
  static std::string word(const Message& message);

  std::vector<Message> messages_;
};

}  // namespace rigsound::can
