#include "ctl/status_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "ctl/status_words.hpp"

namespace rigsound::tools {
namespace {

constexpr int kBarWidth = 40;

std::string age(const Json& signal) {
  if (signal["age_s"].is_null()) return "-";
  const double age_s = signal["age_s"];
  return age_s < 10 ? fmt::format("{:.0f} ms", age_s * 1e3) : fmt::format("{:.0f} s", age_s);
}

std::string audio_lines(const Json& s) {
  const Json& a = s["audio"];
  return fmt::format(
      "rigsoundd {}  {}  up {}{}{}{}\n"
      "audio    {}{}\n"
      "         {}, block {:.2f} ms, load {:.1f} % (mean {:.0f} us, worst {:.0f} us), {} deadline misses\n"
      "         {} xruns, {} suspends, {} losses of the card, {} blocks\n",
      s["version"].get<std::string>(), s["rig"].get<std::string>(), duration_text(s["uptime_s"]),
      s["muted"].get<bool>() ? "  MUTED" : "", s["paused"].get<bool>() ? "  PAUSED" : "",
      s["no_buses"].get<bool>() ? "  MANUAL, NO BUS" : "",
      a["playing"].get<bool>() ? "" : "NO SOUND: ", a["card"].get<std::string>(),
      a["scheduling"].get<std::string>(), a["block_ms"].get<double>(), a["load"].get<double>() * 100,
      a["block_mean_us"].get<double>(), a["block_worst_us"].get<double>(),
      a["deadline_misses"].get<std::uint64_t>(), a["xruns"].get<std::uint64_t>(),
      a["suspends"].get<std::uint64_t>(), a["losses"].get<std::uint64_t>(), a["blocks"].get<std::uint64_t>());
}

std::string level_line(const std::string& name, const Json& level) {
  const std::string peak = db_text(level["peak_db"]), rms = db_text(level["rms_db"]);
  const std::string figures = peak == rms ? peak : fmt::format("{} dBFS peak, {} rms", peak, rms);
  return fmt::format("{:<8} {} {}\n", name, bar_of(level["peak_db"], kBarWidth), figures);
}

std::string meter_lines(const Json& s) {
  const Json& m = s["meters"];
  return level_line("output", m) + level_line("diesel", m["diesel"]) +
         fmt::format("limiter  {:.1f} dB, output gain {:.2f}, {} clicks lost, {} chunks dropped\n",
                     m["limiter_db"].get<double>(), m["output_gain"].get<double>(),
                     m["lost_clicks"].get<std::uint64_t>(), m["dropped_chunks"].get<std::uint64_t>());
}

std::string exposure_text(const Json& s) {
  const Json& e = s["exposure"];
  if (e.is_null()) return {};
  const double down_db = e["turned_down_db"];
  return fmt::format(
      "ear      {:.0f} dB(A) fast, {:.0f} slow, {:.1f} of the last minute{}\n"
      "         L_EX,8h {:.1f} dB(A), L_C,peak {:.0f} dB(C) in {}\n",
      e["laf_db"].get<double>(), e["las_db"].get<double>(), e["laeq_1min_db"].get<double>(),
      down_db > 0 ? fmt::format("; TURNED DOWN {:.1f} dB", down_db) : "", e["lex_8h_db"].get<double>(),
      e["lc_peak_db"].get<double>(), duration_text(e["since_s"]));
}

std::string banks_line(const Json& boom) {
  std::string text;
  for (const Json& bank : boom["banks"]) {
    const int rods = bank["rods"];
    const std::string rock = bank["rock"];
    text += fmt::format("{}{} {:.0f} % ({} rods, {})", text.empty() ? "" : ", ",
                        bank["name"].get<std::string>(), bank["share"].get<double>() * 100,
                        rods > 0 ? std::to_string(rods) : "any", rock.empty() ? "any rock" : rock);
  }
  return text.empty() ? "none" : text;
}

std::string boom_lines(const Json& boom) {
  std::string text = fmt::format(
      "boom     {}: {}, feed deviation {:+.2f}{}\n"
      "         impacts {:.1f} Hz wanted, {:.1f} Hz made; asked for {} rods, rock {}\n"
      "         banks: {}\n",
      boom["name"].get<std::string>(), boom["situation"].get<std::string>(),
      boom["feed_deviation"].get<double>(), boom["hammering"].get<bool>() ? "" : ", hammer off",
      boom["impacts_wanted_hz"].get<double>(), boom["impacts_made_hz"].get<double>(), boom["rods"].get<int>(),
      boom["rock"].get<std::string>(), banks_line(boom));
  for (const auto& [layer, level] : boom["levels"].items()) text += level_line("  " + layer, level);
  const std::string controls = controls_text(boom);
  return text + "         controls: " + (controls.empty() ? "all neutral" : controls) + "\n";
}

std::string words(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

std::string bus_lines(const Json& s) {
  std::string text;
  for (const Json& bus : s["buses"]) {
    text += fmt::format("bus      {} {}\n", bus["name"].get<std::string>(),
                        bus["up"].get<bool>() ? "up" : "DOWN");
    const std::string problem = bus["problem"];
    if (!problem.empty()) text += "         " + problem + "\n";
    const char* separator = "         ";
    for (const auto& [key, value] : bus.items()) {
      if (!value.is_number()) continue;
      text += fmt::format("{}{} {}", separator, value.get<std::uint64_t>(), words(key));
      separator = ", ";
    }
    text += "\n";
  }
  return text;
}

std::string signal_lines(const Json& s) {
  std::string text;
  for (const Json& signal : s["signals"]) {
    const std::string refused = refused_text(signal);
    if (!is_told(signal) && refused.empty()) continue;
    text += fmt::format("  {:<28} {:>10} {:<6} {:>8}  {}{}{}\n", signal["name"].get<std::string>(),
                        value_text(signal), signal["unit"].get<std::string>(), age(signal),
                        signal["validity"].get<std::string>(), refused.empty() ? "" : ", ", refused);
  }
  return text.empty() ? "signals  none seen yet\n" : "signals\n" + text;
}

std::string session_line(const Json& s) {
  const Json& session = s["session"];
  const std::string file = session["file"], problem = session["problem"];
  if (file.empty()) return {};
  if (!problem.empty()) return "session  STOPPED: " + problem + "\n";
  return fmt::format("session  {}, {:.1f} kB\n", file, session["bytes"].get<double>() * 1e-3);
}

}  // namespace

std::string status_text(const Json& status) {
  std::string text = audio_lines(status) + meter_lines(status) + exposure_text(status) + bus_lines(status);
  for (const Json& boom : status["booms"]) text += boom_lines(boom);
  return text + signal_lines(status) + session_line(status);
}

}  // namespace rigsound::tools
