// OSC 1.0 packets: messages, alone or in bundles with the time they are meant for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rigsound::osc {

/// What a message says to its address: a number (also true and false), a word, or that there is none (nil).
using Said = std::variant<std::monostate, double, std::string>;

struct Message {
  std::string path;  ///< "/rigsound/boom2/rattling", or a pattern
  Said said;
  double due_s = 0;  ///< of its bundle, seconds since 1970; 0: at once
};

/// Every message of the packet, bundles in bundles too; nothing when any part is broken or has not one
/// argument: then `problem` says why. Thread: any.
std::optional<std::vector<Message>> read_packet(std::string_view bytes, std::string& problem);

/// One value of a bundle to be sent.
struct Value {
  std::string path;
  std::variant<int, float, std::string> value;
};

std::string write_bundle(const std::vector<Value>& values);  ///< meant for at once. Thread: any.

}  // namespace rigsound::osc
