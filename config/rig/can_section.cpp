#include <algorithm>

#include "rig/sections.hpp"
#include "rigsound/can/frame.hpp"
#include "rigsound/can/signal_reading.hpp"
#include "rigsound/config/dbc.hpp"
#include "rigsound/config/nearest_word.hpp"
#include "rigsound/machine/input_error.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

constexpr std::uint32_t kStandardMask = 0x7FF;
constexpr Range kSourceAddresses{0, 255};

template <class Named>
std::string not_there(const std::string& what, const std::string& name, const std::string& where,
                      const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  const std::string_view near = nearest_word(name, names);
  return "there is no " + what + " '" + name + "' in " + where +
         (near.empty() ? ", expected one of its " + std::to_string(all.size())
                       : ", did you mean '" + std::string(near) + "'?");
}

/// What the DBC must get right before its signal may be used.
std::string flaw(const DbcMessage& message, const DbcSignal& signal, bool fd) {
  const can::SignalLayout& layout = signal.layout;
  if (layout.field.length > 64) return "is longer than 64 bits";
  if (layout.type == can::ValueType::kFloat32 && layout.field.length != 32)
    return "is a float, but not of 32 bits";
  if (layout.type == can::ValueType::kFloat64 && layout.field.length != 64)
    return "is a double, but not of 64 bits";
  const int size = std::min(message.size, fd ? can::kMaxData : 8);
  const auto fits = [size](const can::BitField& field) { return can::last_byte(field) < size; };
  const bool all_fit =
      fits(layout.field) && std::all_of(layout.selectors.begin(), layout.selectors.end(),
                                        [&](const can::Selector& s) { return fits(s.field); });
  if (!all_fit) return "does not fit into the " + std::to_string(size) + " bytes of its frame";
  if (layout.scale == 0) return "has a scale of 0";
  if (!message.extended && message.id > kStandardMask)
    return "is in a message whose identifier has more than 11 bits, but not bit 31 set";
  return {};
}

class CanSection {
 public:
  CanSection(TomlTable table, std::filesystem::path folder)
      : table_(std::move(table)), folder_(std::move(folder)) {}

  can::CanOptions read(const std::vector<BoomOptions>& booms) {
    options_.interface = table_.required_text("interface", "the name of a CAN interface as in `ip link`");
    if (options_.interface.size() > 15) table_.fail("interface", "is too long, expected at most 15 letters");
    config::read(table_, options_);
    forced_j1939_ = table_.has("j1939");
    j1939_ = table_.flag("j1939", false);
    load();
    read_signals(table_.table("signals"), booms,
                 [this](TomlTable& table, const std::string& key, SignalId id) { route(table, key, id); });
    table_.refuse_unknown();
    return std::move(options_);
  }

 private:
  void load() {
    dbc_file_ = folder_ / table_.required_text("dbc", "the path of a DBC file");
    std::error_code error;
    if (!std::filesystem::is_regular_file(dbc_file_, error))
      table_.fail("dbc", "there is no file " + dbc_file_.string() + ", expected a DBC file");
    dbc_ = load_dbc(dbc_file_);
    if (dbc_.messages.empty())
      throw InputError(dbc_file_.string(), "holds no message, expected BO_ sections");
  }

  // "MESSAGE.SIGNAL", or a table { signal = "MESSAGE.SIGNAL", source = 0x00, scale = 1, offset = 0 }.
  void route(TomlTable& table, const std::string& key, SignalId id) {
    can::SignalRoute route;
    route.target = id;
    if (table.is_table(key)) {
      TomlTable details = table.table(key);
      look_up(details, "signal", details.required_text("signal", "\"MESSAGE.SIGNAL\" of the DBC"), route);
      if (details.has("source")) {
        route.match.source = static_cast<std::uint8_t>(details.integer("source", 0, kSourceAddresses));
        if (!route.match.j1939) details.fail("source", "needs a J1939 message, expected j1939 = true");
      }
      scale(details, route.layout);
      details.refuse_unknown();
    } else {
      look_up(table, key, table.required_text(key, "\"MESSAGE.SIGNAL\" of the DBC"), route);
    }
    options_.routes.push_back(std::move(route));
  }

  // What the DBC says is in the bus's unit; the rig turns it into the machine signal's.
  static void scale(TomlTable& details, can::SignalLayout& layout) {
    const double scale = details.number("scale", 1, kBusScales);
    if (scale == 0) details.fail("scale", "is 0, expected any other number");
    layout.scale *= scale;
    layout.offset = layout.offset * scale + details.number("offset", 0, kBusScales);
  }

  void look_up(TomlTable& table, std::string_view key, const std::string& path,
               can::SignalRoute& route) const {
    const std::size_t dot = path.find('.');
    if (dot == std::string::npos) table.fail(key, "\"" + path + "\" has no dot, expected \"MESSAGE.SIGNAL\"");
    const std::string name = path.substr(0, dot), signal_name = path.substr(dot + 1);
    const DbcMessage* message = dbc_.find(name);
    if (message == nullptr) table.fail(key, not_there("message", name, dbc_file_.string(), dbc_.messages));
    const DbcSignal* signal = message->find(signal_name);
    if (signal == nullptr)
      table.fail(key, not_there("signal", signal_name, name + " of " + dbc_file_.string(), message->signals));
    if (const std::string wrong = flaw(*message, *signal, options_.fd); !wrong.empty())
      throw InputError(dbc_file_.string(), signal->line, path, wrong);
    const bool j1939 = (forced_j1939_ ? j1939_ : message->j1939) && message->extended;
    route.name = path;
    route.match = {message->id, message->extended, j1939, {}};
    route.layout = signal->layout;
    route.cycle_s = message->cycle_s;
  }

  TomlTable table_;
  std::filesystem::path folder_, dbc_file_;
  Dbc dbc_;
  bool forced_j1939_ = false, j1939_ = false;
  can::CanOptions options_;
};

}  // namespace

can::CanOptions read_can(TomlTable table, const std::filesystem::path& folder,
                         const std::vector<BoomOptions>& booms) {
  return CanSection(std::move(table), folder).read(booms);
}

}  // namespace rigsound::config
