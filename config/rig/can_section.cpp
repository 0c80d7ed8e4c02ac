#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "dbc/dbc_codes.hpp"
#include "rig/dbc_library.hpp"
#include "rig/plausibility.hpp"
#include "rig/sections.hpp"
#include "rigsound/can/frame.hpp"
#include "rigsound/can/signal_reading.hpp"
#include "rigsound/machine/input_error.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

constexpr Range kSourceAddresses{0, 255};

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
  if (!message.extended && message.id > can::kMaxStandardId)
    return "is in a message whose identifier has more than 11 bits, but not bit 31 set";
  return {};
}

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
  const std::vector<std::filesystem::path>& dbc_files() const { return dbc_files_; }

 private:
  void load(const std::string& text) {
    const std::filesystem::path file = folder_ / text;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
      table_.fail("dbc", "there is no file " + file.string() + ", expected a DBC file");
    library_.add(file);
    dbc_files_.push_back(file);
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
    std::string problem;
    const auto found = library_.find(name, signal_name, problem);
    if (!found) table.fail(key, problem);
    const DbcMessage* const message = found->message;
    const DbcSignal* const signal = found->signal;
    const bool j1939 = (forced_j1939_ ? j1939_ : message->j1939) && message->extended;
    if (const std::string wrong = flaw(*message, *signal, j1939, options_.fd); !wrong.empty())
      throw InputError(*found->file, signal->line, path, wrong);
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

  TomlTable table_;
  std::filesystem::path folder_;
  DbcLibrary library_;
  std::vector<std::filesystem::path> dbc_files_;
  bool forced_j1939_ = false, j1939_ = false;
  can::CanOptions options_;
  std::vector<MappedSignal> mapped_;  ///< of options_.routes
};

}  // namespace

CanBusRead read_can(TomlTable table, const std::filesystem::path& folder,
                    const std::vector<BoomOptions>& booms) {
  CanSection section(std::move(table), folder);
  can::CanOptions options = section.read(booms);
  return {std::move(options), section.dbc_files(), doubts(section.mapped())};
}

}  // namespace rigsound::config
