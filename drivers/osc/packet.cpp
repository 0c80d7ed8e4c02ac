#include "rigsound/osc/packet.hpp"

#include <lo/lo.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <type_traits>

namespace rigsound::osc {
namespace {

constexpr std::string_view kBundle("#bundle\0", 8);
constexpr int kDeepest = 8;
constexpr std::uint64_t kAtOnce = 1;
constexpr double kSecondsFrom1900To1970 = 2208988800.0;

using LoMessage = std::unique_ptr<std::remove_pointer_t<lo_message>, void (*)(lo_message)>;

/// Most significant byte first; moves behind them.
std::uint64_t take_bytes(std::string_view& in, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | static_cast<unsigned char>(in[i]);
  in.remove_prefix(count);
  return value;
}

/// NTP: seconds since 1900 and their fraction.
double seconds_of(std::uint64_t tag) {
  if (tag == kAtOnce) return 0;
  return static_cast<double>(tag >> 32) - kSecondsFrom1900To1970 +
         static_cast<double>(tag & 0xffffffff) * 0x1p-32;
}

std::optional<Said> said_by(char type, lo_arg* argument) {
  const auto lo = static_cast<lo_type>(type);
  if (lo_is_numerical_type(lo) != 0) return static_cast<double>(lo_hires_val(lo, argument));
  if (lo_is_string_type(lo) != 0) return std::string(&argument->s);
  if (type == LO_TRUE || type == LO_FALSE) return type == LO_TRUE ? 1.0 : 0.0;
  if (type == LO_NIL) return Said{};
  return std::nullopt;
}

class PacketReader {
 public:
  std::vector<Message> messages;
  std::string problem;

  bool read(std::string_view bytes, double due_s, int depth) {
    if (depth > kDeepest) return fail("bundles in bundles");
    return bytes.substr(0, kBundle.size()) == kBundle ? read_bundle(bytes, depth)
                                                      : read_message(bytes, due_s);
  }

 private:
  bool fail(const char* what) {
    problem = what;
    return false;
  }

  bool read_bundle(std::string_view bytes, int depth) {
    bytes.remove_prefix(kBundle.size());
    if (bytes.size() < 8) return fail("a bundle without its time");
    const double due_s = seconds_of(take_bytes(bytes, 8));
    while (!bytes.empty()) {
      const std::uint64_t size = bytes.size() < 4 ? 0 : take_bytes(bytes, 4);
      if (size == 0 || size % 4 != 0 || size > bytes.size()) return fail("a bundle that is cut off");
      if (!read(bytes.substr(0, size), due_s, depth + 1)) return false;
      bytes.remove_prefix(size);
    }
    return true;
  }

  bool read_message(std::string_view bytes, double due_s) {
    int error = 0;
    const LoMessage message(
        bytes.empty() ? nullptr
                      : lo_message_deserialise(const_cast<char*>(bytes.data()), bytes.size(), &error),
        lo_message_free);
    if (message == nullptr || bytes.front() != '/') return fail("no OSC message");
    const std::string path(bytes.substr(0, bytes.find('\0')));
    if (lo_message_get_argc(message.get()) != 1) return fail("a message that has not one argument");
    auto said = said_by(lo_message_get_types(message.get())[0], lo_message_get_argv(message.get())[0]);
    if (!said) return fail("an argument that is no number and no word");
    messages.push_back({path, std::move(*said), due_s});
    return true;
  }
};

void add(lo_message message, int value) { lo_message_add_int32(message, value); }
void add(lo_message message, float value) { lo_message_add_float(message, value); }
void add(lo_message message, const std::string& value) { lo_message_add_string(message, value.c_str()); }

}  // namespace

std::optional<std::vector<Message>> read_packet(std::string_view bytes, std::string& problem) {
  PacketReader reader;
  if (reader.read(bytes, 0, 0)) return std::move(reader.messages);
  problem = reader.problem;
  return std::nullopt;
}

std::string write_bundle(const std::vector<Value>& values) {
  constexpr lo_timetag kNow{0, kAtOnce};
  lo_bundle bundle = lo_bundle_new(kNow);
  for (const Value& value : values) {
    lo_message message = lo_message_new();
    std::visit([&](const auto& x) { add(message, x); }, value.value);
    lo_bundle_add_message(bundle, value.path.c_str(), message);
  }
  std::size_t size = 0;
  const std::unique_ptr<void, void (*)(void*)> bytes(lo_bundle_serialise(bundle, nullptr, &size), std::free);
  lo_bundle_free_recursive(bundle);
  return {static_cast<const char*>(bytes.get()), size};
}

}  // namespace rigsound::osc
