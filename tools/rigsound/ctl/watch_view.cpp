#include "ctl/watch_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "ctl/status_words.hpp"
#include "rigsound/machine/signal.hpp"

namespace rigsound::tools {
namespace {

constexpr int kLabelWidth = 24;
constexpr int kMeterWidth = 24;

using Lines = std::vector<std::string>;

std::string cut(std::string text, int width) {
  if (static_cast<int>(text.size()) > width) text = text.substr(0, static_cast<std::size_t>(width - 1)) + "~";
  return text;
}

/// What must not be overlooked comes before figures.
std::string head_line(const Json& s) {
  const Json& a = s["audio"];
  const std::string rig = s["rig"];
  std::string line = "rigsoundd " + rig.substr(rig.rfind('/') + 1);
  if (s["muted"].get<bool>()) line += "  MUTED";
  if (s["paused"].get<bool>()) line += "  PAUSED";
  if (s["no_buses"].get<bool>()) line += "  MANUAL, NO BUS";
  return line + fmt::format("  up {}  load {:.0f} %  {} misses  {} xruns", duration_text(s["uptime_s"]),
                            a["load"].get<double>() * 100, a["deadline_misses"].get<std::uint64_t>(),
                            a["xruns"].get<std::uint64_t>());
}

std::string meter_line(const Json& s) {
  const Json& m = s["meters"];
  const std::uint64_t dropped = m["dropped_chunks"];
  return fmt::format("output {} {:>6} peak {:>6} rms dBFS  limiter {:.1f} dB{}",
                     bar_of(m["peak_db"], kMeterWidth), db_text(m["peak_db"]), db_text(m["rms_db"]),
                     m["limiter_db"].get<double>(),
                     dropped > 0 ? fmt::format("  {} CHUNKS DROPPED", dropped) : "");
}

/// Of a rig that is calibrated.
Lines exposure_lines(const Json& s) {
  const Json& e = s["exposure"];
  if (e.is_null()) return {};
  const double down_db = e["turned_down_db"];
  return {fmt::format(
      "ear {:.0f} dB(A) slow  {:.1f} of the last minute  L_EX,8h {:.1f}  L_C,peak {:.0f} dB(C){}",
      e["las_db"].get<double>(), e["laeq_1min_db"].get<double>(), e["lex_8h_db"].get<double>(),
      e["lc_peak_db"].get<double>(), down_db > 0 ? fmt::format("  TURNED DOWN {:.1f} dB", down_db) : "")};
}

std::string bus_line(const Json& bus) {
  const std::string problem = bus["problem"];
  std::string line =
      fmt::format("{} {}", bus["name"].get<std::string>(), bus["up"].get<bool>() ? "up" : "DOWN");
  if (!problem.empty()) return line + ": " + problem;
  for (const auto& [key, value] : bus.items()) {
    const bool shown = value.is_number() && (value != 0 || key == "frames_used");
    if (shown) line += fmt::format(", {} {}", value.get<std::uint64_t>(), key.substr(key.find('_') + 1));
  }
  return line;
}

std::string marked(const Json& signal) {
  const std::string_view mark = mark_of(signal);
  return fmt::format("{}{}{}", value_text(signal), mark.empty() ? "" : " ", mark);
}

/// Signals of the rig, as many to a line as fit.
Lines rig_lines(const Json& s, int columns) {
  const Json& diesel = s["meters"]["diesel"];
  Lines lines = {fmt::format("diesel {} peak {} rms", db_text(diesel["peak_db"]), db_text(diesel["rms_db"]))};
  for (const Json& signal : s["signals"]) {
    const auto known = signal_by_name(signal["name"].get<std::string>());
    if (!known || info(*known).per_boom || !is_told(signal)) continue;
    const std::string text = fmt::format("{} {}", signal["name"].get<std::string>(), marked(signal));
    if (static_cast<int>(lines.back().size() + text.size()) + 3 > columns)
      lines.push_back(text);
    else
      lines.back() += "   " + text;
  }
  return lines;
}

/// Which signals were refused, when any was.
Lines refused_lines(const Json& s) {
  std::string text;
  for (const Json& signal : s["signals"])
    if (const std::string refused = refused_text(signal); !refused.empty())
      text += (text.empty() ? "" : "; ") + signal["name"].get<std::string>() + " " + refused;
  return text.empty() ? Lines{} : Lines{text};
}

/// Rows of what the booms do: a label, and a cell for each boom.
class BoomTable {
 public:
  BoomTable(const Json& status, int columns) : status_(status), booms_(status["booms"]) {
    const int count = std::max(1, static_cast<int>(booms_.size()));
    cell_ = std::min(34, (columns - kLabelWidth) / count);
  }

  /// Left out when every cell is empty.
  void row(const std::string& label, const std::function<std::string(const Json& boom, int index)>& text) {
    std::string line = fmt::format("{:<{}}", cut(label, kLabelWidth - 1), kLabelWidth);
    bool any = false;
    int index = 0;
    for (const Json& boom : booms_) {
      const std::string cell = text(boom, index++);
      any = any || !cell.empty();
      line += fmt::format("{:<{}}", cut(cell, cell_ - 1), cell_);
    }
    if (any) lines_.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
  }

  void bank_row(const std::string& label, std::size_t rank) {
    row(label, [&](const Json& boom, int) -> std::string {
      if (boom["banks"].size() <= rank) return {};
      const Json& bank = boom["banks"][rank];
      const std::string share = fmt::format(" {:.0f}%", bank["share"].get<double>() * 100);
      return cut(bank["name"], cell_ - 1 - static_cast<int>(share.size())) + share;
    });
  }

  void level_row(const char* layer) {
    row(fmt::format("{} peak/rms dBFS", layer), [&](const Json& boom, int) -> std::string {
      if (!boom["levels"].contains(layer)) return {};
      const Json& level = boom["levels"][layer];
      const std::string peak = db_text(level["peak_db"]), rms = db_text(level["rms_db"]);
      return peak == rms ? peak : peak + " / " + rms;
    });
  }

  void signal_row(const SignalInfo& signal) {
    const std::string name(signal.name);
    row(name, [&](const Json& boom, int index) -> std::string {
      const std::string label = index == 0 ? name : boom["name"].get<std::string>() + "." + name;
      for (const Json& told : status_["signals"])
        if (told["name"] == label) return is_told(told) ? marked(told) : "";
      return {};
    });
  }

  void control_row(const ControlInfo& control) {
    row(std::string(control.name), [&](const Json& boom, int) {
      const double value = boom[std::string(control.name)];
      return value == control.neutral ? "" : fmt::format("{:g}", value);
    });
  }

  Lines lines() && { return std::move(lines_); }

 private:
  const Json& status_;
  const Json& booms_;
  int cell_;
  Lines lines_;
};

/// A column of the watch is as narrow as 14 letters.
std::string situation_text(const Json& boom) {
  const std::string situation = boom["situation"];
  const std::size_t rattling = situation.find("_rattling");
  return (rattling == std::string::npos ? situation : situation.substr(0, rattling) + " rattle") +
         (boom["hammering"].get<bool>() ? "" : ", off");
}

Lines boom_lines(const Json& s, int columns) {
  BoomTable table(s, columns);
  table.row("", [](const Json& boom, int) { return boom["name"].get<std::string>(); });
  table.row("situation", [](const Json& boom, int) { return situation_text(boom); });
  table.row("feed deviation", [](const Json& boom, int) {
    return fmt::format("{:+.2f}", boom["feed_deviation"].get<double>());
  });
  table.bank_row("banks", 0);
  table.bank_row("", 1);
  table.row("rods / rock", [](const Json& boom, int) { return asked_and_got(boom); });
  table.row("impacts wanted/made Hz", [](const Json& boom, int) {
    return fmt::format("{:.1f} / {:.1f}", boom["impacts_wanted_hz"].get<double>(),
                       boom["impacts_made_hz"].get<double>());
  });
  for (const char* layer : {"drill", "tool", "string"}) table.level_row(layer);
  for (const SignalInfo& signal : signal_table())
    if (signal.per_boom) table.signal_row(signal);
  for (const ControlInfo& control : control_table()) table.control_row(control);
  return std::move(table).lines();
}

void append(Lines& lines, const Lines& more) { lines.insert(lines.end(), more.begin(), more.end()); }

std::string fitted(Lines lines, const Screen& screen) {
  const auto rows = static_cast<std::size_t>(screen.rows);
  if (rows > 0 && lines.size() > rows) {
    const std::size_t hidden = lines.size() - rows + 1;
    lines.resize(rows - 1);
    lines.push_back(fmt::format("... {} more lines, see `rigsound ctl status`", hidden));
  }
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + cut(line, screen.columns);
  return text;
}

}  // namespace

std::string watch_text(const Json& s, const Screen& screen) {
  const Json& audio = s["audio"];
  Lines lines = {head_line(s),
                 (audio["playing"].get<bool>() ? "" : "NO SOUND: ") + audio["card"].get<std::string>(),
                 meter_line(s)};
  append(lines, exposure_lines(s));
  for (const Json& bus : s["buses"]) lines.push_back(bus_line(bus));
  append(lines, rig_lines(s, screen.columns));
  append(lines, refused_lines(s));
  append(lines, boom_lines(s, screen.columns));
  return fitted(std::move(lines), screen);
}

std::string waiting_text(const std::string& why, const Screen& screen) {
  return fitted({"waiting for rigsoundd", why}, screen);
}

}  // namespace rigsound::tools
