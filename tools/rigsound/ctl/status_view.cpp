#include "ctl/status_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rigsound::tools {
namespace {

constexpr int kMeterWidth = 40;
constexpr double kMeterFloor_db = -60;

std::string meter(double db) {
  const double share = std::clamp((db - kMeterFloor_db) / -kMeterFloor_db, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(share * kMeterWidth + 0.5);
  return std::string(filled, '#') + std::string(kMeterWidth - filled, '.');
}

std::string age(const Json& signal) {
  if (signal["age_s"].is_null()) return "-";
  const double age_s = signal["age_s"];
  return age_s < 10 ? fmt::format("{:.0f} ms", age_s * 1e3) : fmt::format("{:.0f} s", age_s);
}

std::string audio_lines(const Json& s) {
  const Json& a = s["audio"];
  const Json& m = s["meters"];
  return fmt::format(
      "rigsoundd {}  {}  up {:.0f} s{}\n"
      "audio    {}{}\n"
      "         {}, block {:.2f} ms, load {:.1f} % (mean {:.0f} us, worst {:.0f} us), {} deadline misses\n"
      "         {} xruns, {} suspends, {} losses of the card, {} blocks\n"
      "peak     {} {:6.1f} dBFS\nrms      {} {:6.1f} dBFS\nlimiter  {:.1f} dB\n",
      s["version"].get<std::string>(), s["rig"].get<std::string>(), s["uptime_s"].get<double>(),
      s["muted"].get<bool>() ? "  MUTED" : "",
      a["playing"].get<bool>() ? "" : "NO SOUND: ", a["card"].get<std::string>(),
      a["scheduling"].get<std::string>(), a["block_ms"].get<double>(), a["load"].get<double>() * 100,
      a["block_mean_us"].get<double>(), a["block_worst_us"].get<double>(),
      a["deadline_misses"].get<std::uint64_t>(), a["xruns"].get<std::uint64_t>(),
      a["suspends"].get<std::uint64_t>(), a["losses"].get<std::uint64_t>(), a["blocks"].get<std::uint64_t>(),
      meter(m["peak_db"]), m["peak_db"].get<double>(), meter(m["rms_db"]), m["rms_db"].get<double>(),
      m["limiter_db"].get<double>());
}

std::string words(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

std::string bus_lines(const Json& s) {
  std::string text;
  for (const Json& bus : s["buses"]) {
    fmt::format_to(std::back_inserter(text), "bus      {} {}\n", bus["name"].get<std::string>(),
                   bus["up"].get<bool>() ? "up" : "DOWN");
    const std::string problem = bus["problem"];
    if (!problem.empty()) text += "         " + problem + "\n";
    const char* separator = "         ";
    for (const auto& [key, value] : bus.items()) {
      if (!value.is_number()) continue;
      fmt::format_to(std::back_inserter(text), "{}{} {}", separator, value.get<std::uint64_t>(), words(key));
      separator = ", ";
    }
    text += "\n";
  }
  return text;
}

std::string signal_lines(const Json& s) {
  std::string text;
  for (const Json& signal : s["signals"]) {
    if (signal["age_s"].is_null()) continue;
    fmt::format_to(std::back_inserter(text), "  {:<28} {:>10.3f} {:<6} {:>8}  {}\n",
                   signal["name"].get<std::string>(), signal["value"].get<double>(),
                   signal["unit"].get<std::string>(), age(signal), signal["validity"].get<std::string>());
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
  return audio_lines(status) + bus_lines(status) + signal_lines(status) + session_line(status);
}

}  // namespace rigsound::tools
