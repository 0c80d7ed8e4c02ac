#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "dbc/dbc_codes.hpp"
#include "rig/plausibility.hpp"
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
std::string flaw(const DbcMessage& message, const DbcSignal& signal, bool j1939, bool fd) {
  const can::SignalLayout& layout = signal.layout;
  if (j1939 && message.size > 8 && !fd)
    return "is in a J1939 message of " + std::to_string(message.size) +
           " bytes, which comes by transport protocol (PGN 60416 and 60160) that is not read, expected a "
           "message of at most 8 bytes";
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

/// A DBC file of a bus.
struct DbcFile {
  std::string name;
  Dbc dbc;
};

/// A message in one of the files.
struct Found {
  const DbcFile* file;
  const DbcMessage* message;
};

/// The range that a DBC gives a signal; nothing when it is just all that the field can hold.
std::pair<double, double> range_of(const DbcSignal& signal, bool j1939) {
  constexpr double kRounding = 0.015;  // SPN ranges are written to three digits
  const can::SignalLayout& layout = signal.layout;
  if (layout.type != can::ValueType::kUnsigned) return {signal.min, signal.max};
  double most = std::ldexp(1.0, layout.field.length) - 1;
  const double all[] = {layout.offset, most * layout.scale + layout.offset};
  if (j1939 && layout.field.length >= 8) most = std::floor(most * 251 / 256);
  const double valid[] = {layout.offset, most * layout.scale + layout.offset};
  const auto is = [&](const double(&ends)[2]) {
    const double slack = kRounding * std::fabs(ends[1] - ends[0]);
    return std::fabs(signal.min - ends[0]) <= slack && std::fabs(signal.max - ends[1]) <= slack;
  };
  return is(all) || is(valid) ? std::pair(0.0, 0.0) : std::pair(signal.min, signal.max);
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
    for (const std::string& dbc : table_.one_or_more_texts("dbc", "the path of a DBC file")) load(dbc);
    read_signals(table_.table("signals"), booms,
                 [this](TomlTable& table, const std::string& key, SignalId id) { route(table, key, id); });
    table_.refuse_unknown();
    return std::move(options_);
  }

  const std::vector<MappedSignal>& mapped() const { return mapped_; }

 private:
  void load(const std::string& text) {
    const std::filesystem::path file = folder_ / text;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
      table_.fail("dbc", "there is no file " + file.string() + ", expected a DBC file");
    files_.push_back({file.string(), load_dbc(file)});
    if (!files_.back().dbc.messages.empty()) return;
    const std::vector<std::string>& unread = files_.back().dbc.unread;
    throw InputError(file.string(), unread.empty() ? "holds no message, expected BO_ sections"
                                                   : "holds no message that can be read: " + unread.front());
  }

  // "MESSAGE.SIGNAL", or a table { signal = "MESSAGE.SIGNAL", source = 0x00, scale = 1, offset = 0 }.
  void route(TomlTable& table, const std::string& key, SignalId id) {
    can::SignalRoute route;
    route.target = id;
    mapped_.emplace_back();
    mapped_.back().target = id;
    mapped_.back().where =
        table.file() + ":" + std::to_string(table.line_of(key)) + ": " + table.path_of(key);
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
      const double by_unit = mapped_.back().scale;
      route.layout.scale *= by_unit;
      route.layout.offset *= by_unit;
    }
    options_.routes.push_back(std::move(route));
  }

  // What the DBC says is in the bus's unit; the rig turns it into the machine signal's.
  void scale(TomlTable& details, can::SignalLayout& layout) {
    MappedSignal& mapped = mapped_.back();
    mapped.scale = details.number("scale", mapped.scale, kBusScales);
    if (mapped.scale == 0) details.fail("scale", "is 0, expected any other number");
    mapped.offset = details.number("offset", 0, kBusScales);
    layout.scale *= mapped.scale;
    layout.offset = layout.offset * mapped.scale + mapped.offset;
  }

  void look_up(TomlTable& table, std::string_view key, const std::string& path, can::SignalRoute& route) {
    const std::size_t dot = path.find('.');
    if (dot == std::string::npos) table.fail(key, "\"" + path + "\" has no dot, expected \"MESSAGE.SIGNAL\"");
    const std::string name = path.substr(0, dot), signal_name = path.substr(dot + 1);
    const auto [file, message] = the_message(table, key, name);
    if (!message->broken.empty()) table.fail(key, name + " cannot be read: " + message->broken);
    const DbcSignal* signal = message->find(signal_name);
    if (signal == nullptr)
      table.fail(key, not_there("signal", signal_name, name + " of " + file->name, message->signals));
    const bool j1939 = (forced_j1939_ ? j1939_ : message->j1939) && message->extended;
    if (const std::string wrong = flaw(*message, *signal, j1939, options_.fd); !wrong.empty())
      throw InputError(file->name, signal->line, path, wrong);
    route.name = path;
    route.match = {message->id, message->extended, j1939, {}};
    route.layout = signal->layout;
    route.layout.codes = raw_codes(*signal);
    route.cycle_s = message->cycle_s;
    MappedSignal& mapped = mapped_.back();
    mapped.name = path;
    mapped.unit = signal->unit;
    std::tie(mapped.min, mapped.max) = range_of(*signal, j1939);
    mapped.scale = scale_of_unit(mapped.target.signal, signal->unit);
  }

  /// The one message of that name in all files.
  Found the_message(const TomlTable& table, std::string_view key, const std::string& name) const {
    std::vector<Found> found;
    for (const DbcFile& file : files_)
      if (const DbcMessage* message = file.dbc.find(name)) found.push_back({&file, message});
    if (found.size() == 1) return found.front();
    const auto place = [](const Found& f) { return f.file->name + ":" + std::to_string(f.message->line); };
    if (!found.empty())
      table.fail(key, "there is a message '" + name + "' in " + place(found[0]) + " and in " +
                          place(found[1]) + ", expected it in one of them");
    std::vector<DbcMessage> all;
    std::string where, unread;
    for (const DbcFile& file : files_) {
      all.insert(all.end(), file.dbc.messages.begin(), file.dbc.messages.end());
      where += (where.empty() ? "" : " and ") + file.name;
      for (const std::string& line : file.dbc.unread) unread += "; not read: " + line;
    }
    table.fail(key, not_there("message", name, where, all) + unread);
  }

  TomlTable table_;
  std::filesystem::path folder_;
  std::vector<DbcFile> files_;
  bool forced_j1939_ = false, j1939_ = false;
  can::CanOptions options_;
  std::vector<MappedSignal> mapped_;  ///< of options_.routes
};

}  // namespace

CanBusRead read_can(TomlTable table, const std::filesystem::path& folder,
                    const std::vector<BoomOptions>& booms) {
  CanSection section(std::move(table), folder);
  can::CanOptions options = section.read(booms);
  return {std::move(options), doubts(section.mapped())};
}

}  // namespace rigsound::config
