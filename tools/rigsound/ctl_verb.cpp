#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "ctl/control_client.hpp"
#include "ctl/status_view.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct Options {
  std::string socket = "/run/rigsound/control.sock";
  bool json = false;
  std::string key;
  double value = 0, seconds = 0.2;
  std::string mute;
};

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void status(const Options& o) {
  const Json answer = ControlClient(o.socket).ask({{"command", "status"}});
  print(o.json ? answer.dump() + "\n" : status_text(answer));
}

/// Overwrites the view before instead of clearing it first, which would flicker.
std::string in_place(const std::string& text) {
  constexpr const char *kHome = "\033[H", *kClearLine = "\033[K\n", *kClearBelow = "\033[J";
  std::string view = kHome;
  for (const char c : text) view.append(c == '\n' ? kClearLine : std::string(1, c));
  return view + kClearBelow;
}

// Ends with the daemon, or by Ctrl-C; on a terminal each view replaces the one before.
void watch(const Options& o) {
  ControlClient client(o.socket);
  const bool terminal = ::isatty(STDOUT_FILENO) != 0;
  for (;;) {
    const std::string text = status_text(client.ask({{"command", "status"}}));
    print(terminal ? in_place(text) : text);
    std::fflush(stdout);
    std::this_thread::sleep_for(std::chrono::duration<double>(o.seconds));
  }
}

void set_control(const Options& o) {
  ControlClient(o.socket).ask({{"command", "set"}, {"key", o.key}, {"value", o.value}});
}

void reload(const Options& o) {
  const Json answer = ControlClient(o.socket).ask({{"command", "reload"}});
  print("reloaded\n");
  for (const Json& key : answer["not_applied"])
    std::fprintf(stderr, "needs a restart: %s\n", key.get<std::string>().c_str());
}

void mute(const Options& o) {
  Json request = {{"command", "mute"}};
  if (!o.mute.empty()) request["on"] = o.mute == "on";
  const Json answer = ControlClient(o.socket).ask(request);
  print(answer["muted"].get<bool>() ? "muted\n" : "unmuted\n");
}

void metrics(const Options& o) {
  print(ControlClient(o.socket).ask({{"command", "metrics"}})["text"].get<std::string>());
}

}  // namespace

void add_ctl(cli::Verb& program) {
  cli::Verb ctl = program.verb("ctl", "Talk to the running daemon").group(kRun).options_anywhere();
  auto options = std::make_shared<Options>();
  ctl.option("--socket", options->socket, "the rig's [control] socket").shows_default();
  const auto add = [&](const char* name, const char* summary, void (*run)(const Options&),
                       const char* arguments) {
    cli::Verb command = ctl.verb(name, summary);
    command.example(std::string("rigsound ctl ") + name + arguments);
    command.callback([run, options] { run(*options); });
    return command;
  };
  add("status", "Show audio, meters, buses and signals", status, " --json")
      .flag("--json", options->json, "one JSON object");
  add("watch", "Show the status again and again", watch, " --every 1")
      .option("--every", options->seconds, "seconds between two views")
      .range(0.02, 3600)
      .shows_default();
  cli::Verb set =
      add("set", "Change a live control of the drill", set_control, " boom1.mean_frequency_hz 42");
  set.positional("KEY", options->key, "[BOOM.]CONTROL, see `rigsound ctl --help`; without BOOM all booms")
      .required();
  set.positional("VALUE", options->value, "number").required();
  add("reload", "Read the rig again, all of it or none", reload, "");
  add("mute", "Silence the sound, or let it be heard again", mute, " on")
      .positional("STATE", options->mute, "on or off; left out: the other one")
      .one_of({"on", "off"});
  add("metrics", "Print OpenMetrics text", metrics, "");
  ctl.details(
      "Controls: mean_frequency_hz (1...100 Hz; 0: the machine's own), mean_amplitude_db (-60...24), "
      "deviation_time and deviation_amplitude (factors 0...4), attack_factor (0.1...10), decay_factor "
      "(0.25...10).");
  ctl.example("rigsound ctl set boom1.mean_frequency_hz 42");
}

}  // namespace rigsound::tools
