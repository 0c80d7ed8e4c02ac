#include "can/source_watch.hpp"

#include <algorithm>
#include <cstdio>

#include "rigsound/can/signal_reading.hpp"

namespace rigsound::can {
namespace {

std::string hex(std::uint8_t byte) {
  char text[8];
  std::snprintf(text, sizeof text, "%02X", byte);
  return text;
}

}  // namespace

SourceWatch::SourceWatch(const std::vector<SignalRoute>& routes) {
  for (const SignalRoute& route : routes) {
    const std::string name = route.name.substr(0, route.name.find('.'));
    const bool known = std::any_of(messages_.begin(), messages_.end(),
                                   [&](const Message& message) { return message.name == name; });
    if (route.match.j1939 && !route.match.source && !known) messages_.push_back({name, route.match, {}});
  }
}

std::string SourceWatch::word(const Message& message) {
  std::string list;
  for (const std::uint8_t source : message.sources) list += (list.empty() ? "" : ", ") + hex(source);
  return message.name + " comes from " + list + ": all are taken in turn, source = 0x" +
         hex(*message.sources.begin()) + " takes one";
}

std::optional<std::string> SourceWatch::add(const Frame& frame) {
  for (Message& message : messages_) {
    if (!matches(message.match, frame)) continue;
    const bool fresh = message.sources.insert(static_cast<std::uint8_t>(frame.id & 0xFF)).second;
    if (fresh && message.sources.size() == 2) return word(message);
  }
  return std::nullopt;
}

std::vector<std::string> SourceWatch::found() const {
  std::vector<std::string> words;
  for (const Message& message : messages_)
    if (message.sources.size() > 1) words.push_back(word(message));
  return words;
}

}  // namespace rigsound::can
