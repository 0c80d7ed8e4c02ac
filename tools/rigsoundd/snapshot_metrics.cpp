// OpenMetrics 1.0: families in turn, counters end in _total, base units, `# EOF` at the end.
#include <fmt/format.h>

#include <iterator>
#include <map>

#include "rigsound/machine/safety.hpp"
#include "snapshot.hpp"

namespace rigsound::daemon {
namespace {

struct CounterText {
  const char* name;
  const char* help;
};
constexpr CounterText kCardCounters[audio::kCardEventCount] = {
    {"xruns", "Buffer underruns of the sound card."},
    {"suspends", "Times the sound card was suspended."},
    {"bad_states", "Times the sound card was in a state that takes no samples."},
    {"short_writes", "Blocks the sound card took in pieces."},
    {"interruptions", "Writes to the sound card that a signal interrupted."},
    {"card_losses", "Times the sound card was given up."}};
constexpr CounterText kBusCounters[] = {
    {"frames_seen", "Frames or requests that arrived."},
    {"frames_used", "Frames or requests that carried a signal of the rig."},
    {"frames_bad", "Error frames of the CAN controller, or bytes that are no Modbus."},
    {"frames_dropped", "Frames the kernel dropped because they were not fetched in time."},
    {"requests_refused", "Modbus requests answered with an exception."},
    {"rejected_connections", "Modbus connections from a network not allowed."},
    {"evicted_connections", "Modbus connections closed to make room for the next."},
    {"frames_rejected", "Datagrams from a network not allowed."},
    {"frames_late", "Datagrams older than one before."},
    {"losses", "Times the bus or the device went away."}};
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '"') out.push_back('\\');
    out.append(c == '\n' ? "\\n" : std::string(1, c));
  }
  return out;
}

class Page {
 public:
  void family(const char* name, const char* type, const char* help, const char* unit = "") {
    text_ += fmt::format("# TYPE rigsound_{} {}\n", name, type);
    if (*unit != 0) text_ += fmt::format("# UNIT rigsound_{} {}\n", name, unit);
    text_ += fmt::format("# HELP rigsound_{} {}\n", name, help);
  }
  template <typename Number>
  void sample(const std::string& name, const std::string& labels, Number value) {
    text_ += fmt::format("rigsound_{}{} {}\n", name, labels.empty() ? "" : "{" + labels + "}", value);
  }
  template <typename Number>
  void counter(const char* name, Number value, const char* help) {
    family(name, "counter", help);
    sample(std::string(name) + "_total", "", value);
  }
  void gauge(const char* name, double value, const char* help, const char* unit = "") {
    family(name, "gauge", help, unit);
    sample(name, "", value);
  }
  std::string finish() { return text_ + "# EOF\n"; }

 private:
  std::string text_;
};

void add_audio(Page& page, const Snapshot& s) {
  page.counter("blocks", s.blocks, "Blocks rendered.");
  for (std::size_t i = 0; i < s.card.events.size(); ++i)
    page.counter(kCardCounters[i].name, s.card.events[i], kCardCounters[i].help);
  page.counter("deadline_misses", s.deadline_misses, "Blocks that took longer to compute than to play.");
  page.counter("clock_jumps", s.clock_jumps, "Times no block was rendered for over a second.");
  page.counter("skipped_blocks", s.skipped_blocks, "Blocks that were not rendered then.");
  page.gauge("card_playing", s.card.playing ? 1 : 0, "1 while a sound card is open; never for device null.");
  page.gauge("block_time_mean_seconds", s.block_mean_s, "Time to compute a block, mean.", "seconds");
  page.gauge("block_time_worst_seconds", s.block_worst_s, "Time to compute a block, worst.", "seconds");
  page.gauge("limiter_gain_since_scrape_ratio", s.limiter_gain, "Lowest limiter gain since the last scrape.",
             "ratio");
  page.gauge("peak_since_scrape_ratio", s.output.peak, "Peak since the last scrape, full scale 1.", "ratio");
  page.gauge("rms_since_scrape_ratio", s.output.rms, "RMS since the last scrape, full scale 1.", "ratio");
  page.counter("lost_clicks", s.lost_clicks, "Clicks that found every voice busy.");
  page.counter("dropped_chunks", s.dropped_chunks,
               "Chunks of 32 frames that a layer was left out of: what it made was no number.");
  page.gauge("output_gain_ratio", s.output_gain, "Safety rules, mute and fades together.", "ratio");
}

void add_exposure(Page& page, const Snapshot& s) {
  if (!s.exposure) return;
  const ExposureSnapshot& e = *s.exposure;
  page.gauge("sound_level_fast_decibels", e.fast_db, "A-weighted level at the ear, fast.", "decibels");
  page.gauge("sound_level_slow_decibels", e.slow_db, "A-weighted level at the ear, slow.", "decibels");
  page.gauge("sound_level_minute_decibels", e.minute_db,
             "A-weighted equivalent level at the ear over about a minute.", "decibels");
  page.gauge("exposure_8h_decibels", e.day_db, "L_EX,8h since the start or the last reset.", "decibels");
  page.gauge("exposure_peak_decibels", e.peak_db, "L_C,peak since the start or the last reset.", "decibels");
  page.gauge("exposure_turned_down_decibels", e.turned_down_db,
             "How far the limit has turned the output down.", "decibels");
}

// One family per counter name, one sample per bus that has it.
void add_buses(Page& page, const Snapshot& s) {
  page.family("bus_up", "gauge", "1 while the bus delivers.");
  for (const BusSnapshot& bus : s.buses)
    page.sample("bus_up", "bus=\"" + escaped(bus.name) + "\"", bus.up ? 1 : 0);
  for (const auto& [name, help] : kBusCounters) {
    const std::string family = std::string("bus_") + name;
    page.family(family.c_str(), "counter", help);
    for (const BusSnapshot& bus : s.buses)
      for (const auto& [counter, value] : bus.counters)
        if (counter == name) page.sample(family + "_total", "bus=\"" + escaped(bus.name) + "\"", value);
  }
}

using LevelMember = double LevelSnapshot::*;

void add_layers(Page& page, const Snapshot& s, const std::string& family, LevelMember member,
                const char* help) {
  page.family(family.c_str(), "gauge", help, "ratio");
  page.sample(family, "layer=\"diesel\"", s.diesel.*member);
  for (const BoomSnapshot& boom : s.booms) {
    const auto add = [&](const std::string& layer, const LevelSnapshot& level) {
      page.sample(family, fmt::format("boom=\"{}\",layer=\"{}\"", escaped(boom.name), layer), level.*member);
    };
    add("drill", boom.drill_level);
    if (!boom.tool.empty()) add(boom.tool, boom.tool_level);
  }
}

/// A gauge of every boom.
template <class Value>
void add_boom_gauge(Page& page, const Snapshot& s, const char* name, const char* help, const char* unit,
                    Value value) {
  page.family(name, "gauge", help, unit);
  for (const BoomSnapshot& boom : s.booms)
    page.sample(name, "boom=\"" + escaped(boom.name) + "\"", value(boom));
}

/// Shares by the labels of their series: one bank may serve two situations.
std::map<std::string, double> bank_shares(const BoomSnapshot& boom) {
  std::map<std::string, double> shares;
  for (const BankSnapshot& bank : boom.banks)
    shares[fmt::format("boom=\"{}\",bank=\"{}\",rods=\"{}\",rock=\"{}\"", escaped(boom.name),
                       escaped(bank.name), bank.rods > 0 ? std::to_string(bank.rods) : "any",
                       bank.rock.empty() ? "any" : escaped(bank.rock))] += bank.share;
  return shares;
}

void add_booms(Page& page, const Snapshot& s) {
  page.family("boom_situation", "stateset", "What the drill is doing.");
  for (const BoomSnapshot& boom : s.booms)
    for (int i = 0; i < kSituationCount; ++i)
      page.sample(
          "boom_situation",
          fmt::format("boom=\"{}\",rigsound_boom_situation=\"{}\"", escaped(boom.name), kSituationNames[i]),
          boom.situation == static_cast<Situation>(i) ? 1 : 0);
  add_boom_gauge(page, s, "boom_feed_deviation",
                 "Feed: -1 underfeed bank, 0 normal, 1 overfeed bank, and beyond.", "",
                 [](const BoomSnapshot& b) { return b.feed_deviation; });
  add_boom_gauge(page, s, "boom_hammering", "1 while the hammer works.", "",
                 [](const BoomSnapshot& b) { return b.hammering ? 1 : 0; });
  add_boom_gauge(page, s, "boom_impacts_wanted_hertz",
                 "Impacts a second asked for; 0 while the hammer rests.", "hertz",
                 [](const BoomSnapshot& b) { return b.impacts_wanted_hz; });
  add_boom_gauge(page, s, "boom_impacts_made_hertz", "Impacts of the last second.", "hertz",
                 [](const BoomSnapshot& b) { return b.impacts_made_hz; });
  page.family("boom_bank_share_ratio", "gauge", "How much of the drill's sound is this bank's.", "ratio");
  for (const BoomSnapshot& boom : s.booms)
    for (const auto& [labels, share] : bank_shares(boom)) page.sample("boom_bank_share_ratio", labels, share);
}

void add_signal_counter(Page& page, const Snapshot& s, const std::string& family, const char* help,
                        std::uint64_t SignalSnapshot::*count) {
  page.family(family.c_str(), "counter", help);
  for (const SignalSnapshot& signal : s.signals)
    page.sample(family + "_total", "signal=\"" + escaped(signal.name) + "\"", signal.*count);
}

void add_signals(Page& page, const Snapshot& s) {
  page.family("signal_age_seconds", "gauge", "Time since the signal was last good.", "seconds");
  for (const SignalSnapshot& signal : s.signals)
    if (signal.age_s >= 0)
      page.sample("signal_age_seconds", "signal=\"" + escaped(signal.name) + "\"", signal.age_s);
  page.family("signal_value", "gauge", "What the engine is given, once a bus or a user has said it.");
  for (const SignalSnapshot& signal : s.signals)
    if (signal.age_s >= 0 || signal.validity == name(Validity::kManual))
      page.sample("signal_value",
                  fmt::format("signal=\"{}\",unit=\"{}\"", escaped(signal.name), escaped(signal.unit)),
                  signal.value);
  add_signal_counter(page, s, "signal_refused", "Values that were none, or out of range.",
                     &SignalSnapshot::refused);
  add_signal_counter(page, s, "signal_clamped", "Values brought to the end of the range.",
                     &SignalSnapshot::clamped);
  page.family("signal_state", "stateset", "Whether the signal may be believed.");
  for (const SignalSnapshot& signal : s.signals)
    for (int i = 0; i < kValidityCount; ++i) {
      const std::string_view state = name(static_cast<Validity>(i));
      page.sample("signal_state",
                  fmt::format("signal=\"{}\",rigsound_signal_state=\"{}\"", escaped(signal.name), state),
                  signal.validity == state ? 1 : 0);
    }
}

}  // namespace

std::string to_openmetrics(const Snapshot& s) {
  Page page;
  add_audio(page, s);
  add_exposure(page, s);
  add_layers(page, s, "layer_peak_since_scrape_ratio", &LevelSnapshot::peak,
             "Peak of a layer before pan, output level and limiter, since the last scrape.");
  add_layers(page, s, "layer_rms_since_scrape_ratio", &LevelSnapshot::rms,
             "RMS of a layer before pan, output level and limiter, since the last scrape.");
  add_booms(page, s);
  add_buses(page, s);
  add_signals(page, s);
  page.counter("lost_log_entries", s.lost_log_entries,
               "Log entries dropped because the log could not keep up.");
  page.counter("lost_session_records", s.lost_records, "Changes of state that a session could not keep.");
  page.counter("reloads", s.reloads, "Successful reloads.");
  page.counter("failed_reloads", s.failed_reloads, "Reloads refused; the old rig went on.");
  return page.finish();
}

}  // namespace rigsound::daemon
