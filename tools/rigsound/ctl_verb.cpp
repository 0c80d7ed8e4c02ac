#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/number_text.hpp"
#include "ctl/control_client.hpp"
#include "ctl/status_view.hpp"
#include "ctl/watch_view.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/machine/signal.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct CtlArguments {
  std::string socket = "/run/rigsound/control.sock";
  bool json = false;
  std::string key, value;
  double seconds = 0.2;
  std::string mute, exposure;
  std::vector<std::string> topics;
};

void status(const CtlArguments& o) {
  const Json answer = ControlClient(o.socket).ask({{"command", "status"}});
  fmt::print("{}", o.json ? config::json_line(answer) + "\n" : status_text(answer));
}

/// Overwrites the view before instead of clearing it first, which would flicker.
std::string in_place(const std::string& text) {
  constexpr const char *kHome = "\033[H", *kClearLine = "\033[K\n", *kClearBelow = "\033[J";
  std::string view = kHome;
  for (const char c : text) view.append(c == '\n' ? kClearLine : std::string(1, c));
  return view + kClearBelow;
}

std::optional<Screen> terminal() {
  if (::isatty(STDOUT_FILENO) == 0) return std::nullopt;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return Screen{};
  return Screen{size.ws_col, size.ws_row - 1};  // the last row is the prompt's, after Ctrl-C
}

/// What there is to show: the status, or why there is none.
class Watched {
 public:
  explicit Watched(const std::string& socket) : socket_(socket) {}

  std::string text(const Screen& screen) {
    try {
      if (!client_) client_.emplace(socket_);
      return watch_text(client_->ask({{"command", "status"}}), screen);
    } catch (const DeviceError& error) {
      client_.reset();
      return waiting_text(error.what(), screen);
    }
  }

 private:
  std::string socket_;
  std::optional<ControlClient> client_;
};

// Ends by Ctrl-C; on a terminal each view replaces the one before, elsewhere a view like the last is not
// repeated.
void watch(const CtlArguments& o) {
  Watched watched(o.socket);
  std::string last;
  for (;;) {
    const std::optional<Screen> screen = terminal();
    const std::string text = watched.text(screen.value_or(Screen{100, 0}));
    if (screen)
      fmt::print("{}", in_place(text + "\n"));
    else if (text != last)
      fmt::print("{}\n", text);
    last = text;
    std::fflush(stdout);
    std::this_thread::sleep_for(std::chrono::duration<double>(o.seconds));
  }
}

/// A line for each value of `change`, behind `time`: `signals.engine_rpm.value 1500`; `-` for what is no
/// longer there.
void print_changes(const std::string& time, const std::string& path, const Json& change) {
  if (!change.is_object()) {
    const std::string value = change.is_null()           ? "-"
                              : change.is_string()       ? change.get<std::string>()
                              : change.is_number_float() ? fmt::format("{:.5g}", change.get<double>())
                                                         : config::json_line(change);
    return fmt::print("{} {} {}\n", time, path, value);
  }
  for (const auto& [key, value] : change.items())
    print_changes(time, path.empty() ? key : fmt::format("{}.{}", path, key), value);
}

// Ends by Ctrl-C.
void subscribe(const CtlArguments& o) {
  ControlClient client(o.socket);
  Json request = {{"command", "subscribe"}, {"every_s", o.seconds}};
  if (!o.topics.empty()) request["topics"] = o.topics;
  client.ask(request);
  for (;;) {
    const Json event = client.next_object();
    if (o.json)
      fmt::print("{}\n", config::json_line(event));
    else
      print_changes(fmt::format("{:.1f}", event["uptime_s"].get<double>()), "", event["change"]);
    std::fflush(stdout);
  }
}

void set_value(const CtlArguments& o) {
  Json request = {{"command", "set"}, {"key", o.key}, {"value", o.value}};
  if (cli::number_fault(o.value).empty()) request["value"] = cli::number_of(o.value);
  const Json answer = ControlClient(o.socket).ask(request);
  for (const Json& set : answer["set"])
    fmt::print("{} {}{}\n", set["name"].get<std::string>(), o.value,
               set["manual"].get<bool>() ? ", by hand until `rigsound ctl release`" : "");
}

void release_value(const CtlArguments& o) {
  const Json answer = ControlClient(o.socket).ask({{"command", "release"}, {"key", o.key}});
  for (const Json& name : answer["released"]) fmt::print("released {}\n", name.get<std::string>());
  if (answer["released"].empty()) fmt::print("nothing to release\n");
}

/// What may be set, a line each: `NAME RANGE: MEANING`.
std::string settable() {
  std::string text = "Signals of the machine, which then stand until released, whatever a bus says:\n";
  const auto add = [&text](std::string_view name, const std::string& range, std::string_view meaning) {
    text += fmt::format("{} {}: {}\n", name, range, meaning);
  };
  for (const SignalInfo& signal : signal_table()) {
    std::string range(signal.words);
    for (char& c : range)
      if (c == '|') c = ',';
    add(signal.name, range.empty() ? signal.range().text() : range, signal.meaning);
  }
  text += "\nControls of the drill:\n";
  for (const ControlInfo& control : control_table())
    add(control.name, control.range().text(), control.meaning);
  return text;
}

void reload(const CtlArguments& o) {
  const Json answer = ControlClient(o.socket).ask({{"command", "reload"}});
  fmt::print("reloaded\n");
  for (const Json& key : answer["not_applied"])
    std::fprintf(stderr, "needs a restart: %s\n", key.get<std::string>().c_str());
}

void mute(const CtlArguments& o) {
  Json request = {{"command", "mute"}};
  if (!o.mute.empty()) request["on"] = o.mute == "on";
  const Json answer = ControlClient(o.socket).ask(request);
  fmt::print("{}", answer["muted"].get<bool>() ? "muted\n" : "unmuted\n");
}

void metrics(const CtlArguments& o) {
  fmt::print("{}", ControlClient(o.socket).ask({{"command", "metrics"}})["text"].get<std::string>());
}

void exposure(const CtlArguments& o) {
  ControlClient(o.socket).ask({{"command", "exposure_reset"}});
  fmt::print("exposure begins again\n");
}

using Shared = std::shared_ptr<CtlArguments>;

cli::Verb add(cli::Verb& ctl, const Shared& options, const char* name, const char* summary,
              void (*run)(const CtlArguments&)) {
  cli::Verb command = ctl.verb(name, summary);
  command.callback([run, options] { run(*options); });
  return command;
}

void add_views(cli::Verb& ctl, const Shared& o) {
  cli::Verb show =
      add(ctl, o, "status", "Show audio, meters, buses, booms, signals: why it sounds like this", status);
  show.flag("--json", o->json, "one JSON object");
  show.example("rigsound ctl status --json");
  cli::Verb look = add(ctl, o, "watch", "Show the status on one screen, again and again", watch);
  look.option("--every", o->seconds, "time between two views").range(0.02, 3600, "s").shows_default();
  look.details("Waits for a daemon that is not there yet, or has gone. Ends by Ctrl-C.");
  look.example("rigsound ctl watch --every 1");
  cli::Verb changes = add(ctl, o, "subscribe", "Print what changes, a line each", subscribe);
  changes.flag("--json", o->json, "one JSON object a line, a merge patch (RFC 7396) of the one before");
  changes.option("--every", o->seconds, "seconds between two looks").range(0.1, 3600).shows_default();
  changes
      .option("--topics", o->topics, "parts of the status, such as signals,booms,meters; left out: all of it")
      .separated_by_commas();
  changes.details("Begins with everything. Ends by Ctrl-C.");
  changes.example("rigsound ctl subscribe --topics signals,booms");
  add(ctl, o, "metrics", "Print OpenMetrics text", metrics).example("rigsound ctl metrics");
}

void add_settings(cli::Verb& ctl, const Shared& o) {
  cli::Verb set =
      add(ctl, o, "set", "Set a signal of the machine by hand, or a control of the drill", set_value);
  set.positional("KEY", o->key, "[BOOM.]SIGNAL or [BOOM.]CONTROL, listed below; without BOOM all booms")
      .required();
  set.positional("VALUE", o->value, "number or word").required();
  set.details(settable());
  set.example("rigsound ctl set feed_pressure_bar 130");
  set.example("rigsound ctl set boom2.rattling open");
  set.example("rigsound ctl set boom1.mean_frequency_hz 42");
  cli::Verb release =
      add(ctl, o, "release", "Give a signal back to its bus, bring a control back to neutral", release_value);
  release.positional("KEY", o->key, "[BOOM.]SIGNAL or [BOOM.]CONTROL, listed below, or `all`").required();
  release.details(settable());
  release.example("rigsound ctl release feed_pressure_bar");
  cli::Verb silence = add(ctl, o, "mute", "Silence the sound, or let it be heard again", mute);
  silence.positional("STATE", o->mute, "on or off; left out: the other one").one_of({"on", "off"});
  silence.example("rigsound ctl mute on");
  cli::Verb ears = add(ctl, o, "exposure", "Let daily exposure and peak level begin again", exposure);
  ears.positional("WHAT", o->exposure, "reset").required().one_of({"reset"});
  ears.details("For a rig with [mix] db_spl_at_0dbfs. `ctl status` shows both.");
  ears.example("rigsound ctl exposure reset");
  add(ctl, o, "reload", "Read the rig again, all of it or none", reload).example("rigsound ctl reload");
}

}  // namespace

void add_ctl(cli::Verb& program) {
  cli::Verb ctl = program.verb("ctl", "Talk to the running daemon").group(kRun).options_anywhere();
  const auto options = std::make_shared<CtlArguments>();
  ctl.option("--socket", options->socket, "the rig's [control] socket").shows_default();
  add_views(ctl, options);
  add_settings(ctl, options);
  ctl.details("`rigsound ctl set --help` lists what can be set.");
  ctl.example("rigsound ctl set feed_pressure_bar 130");
}

}  // namespace rigsound::tools
