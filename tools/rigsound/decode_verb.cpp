#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "decode/row_text.hpp"
#include "decode/state_rows.hpp"
#include "log_arguments.hpp"
#include "log_notes.hpp"
#include "progress_bar.hpp"
#include "refused_values.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/log/change_trace.hpp"
#include "rigsound/session/session_folder.hpp"
#include "rigsound/session/session_states.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct DecodeArguments {
  std::string rig, session;
  LogArguments log;
  bool json = false;

  StateRows::Form form() const { return json ? StateRows::Form::kJson : StateRows::Form::kCsv; }
};

std::vector<SignalId> watched(const config::Rig& rig) {
  std::vector<SignalId> ids;
  for (const config::SignalSource& source : config::sources_of(rig)) ids.push_back(source.signal);
  return ids;
}

/// Adds the rows of a log's changes, and of what follows from them, once all of one time are known.
class LogRows {
 public:
  LogRows(const config::Rig& rig, StateRows& rows) : rows_(rows) {
    for_each_signal(kMaxBooms, [&](SignalId id) { label_of(id) = config::signal_label(rig, id); });
  }

  void add(const log::Change& change) {
    if (change.time_s != time_s_) add_situations();
    time_s_ = change.time_s;
    add_row(change);
    const SignalInfo& signal = info(change.signal.signal);
    signal.set(state_, change.signal.boom, change.value);
    if (signal.per_boom) told_[change.signal.boom] = true;
  }

  void add_situations() {
    for (int b = 0; b < kMaxBooms; ++b)
      if (told_[b]) rows_.add_situation(time_s_, b, state_.boom[b]);
  }

 private:
  std::string& label_of(SignalId id) { return labels_[static_cast<std::size_t>(id.signal)][id.boom]; }

  void add_row(const log::Change& change) {
    const std::string_view word = value_word(change.signal.signal, change.value);
    if (!word.empty()) return rows_.add(time_s_, label_of(change.signal), word);
    fmt::memory_buffer text;
    append_value(text, change.value);
    rows_.add(time_s_, label_of(change.signal), {text.data(), text.size()});
  }

  StateRows& rows_;
  std::array<std::array<std::string, kMaxBooms>, kSignalCount> labels_;
  double time_s_ = 0;
  MachineState state_;
  std::array<bool, kMaxBooms> told_{};
};

void decode_log(const DecodeArguments& options) {
  const config::Rig rig = config::load_rig(options.rig);
  const std::unique_ptr<log::BusLog> log =
      log::open_log(options.log.log, config::buses_of(rig), log_options(options.log));
  StateRows rows(rig, options.form(), stdout);
  LogRows changes(rig, rows);
  ProgressBar bar(ProgressBar::Beside::kRows);
  const SignalBoard board =
      log::trace_changes(*log, rig.safety, watched(rig), [&](const log::Change& change) {
        changes.add(change);
        bar.show(log->share());
      });
  bar.clear();
  changes.add_situations();
  rows.finish();
  print_log_notes(options.log.log, *log);
  print_refused_values(rig, board);
}

void decode_session(const DecodeArguments& options) {
  const config::Rig rig = config::load_rig(options.rig, config::Buses::kLeftOut);
  const std::filesystem::path file = session::newest_session(options.session);
  const session::SessionStates states(file);
  const session::SessionHeader& header = states.header();
  const double block_s = header.block / header.sample_rate;
  StateRows rows(rig, options.form(), stdout);
  session::SessionChanges changes = states.changes();
  ProgressBar bar(ProgressBar::Beside::kRows);
  for (session::Change change; changes.next(change);) {
    rows.add_state(static_cast<double>(change.block + change.skipped) * block_s, change.state);
    bar.show(static_cast<double>(change.block) /
             static_cast<double>(std::max<std::uint64_t>(1, states.blocks())));
  }
  bar.clear();
  rows.finish();
  fmt::print(stderr, "{}: {:.1f} s, played by rigsound {} at {:g} Hz in blocks of {} frames, seed {}\n",
             file.string(), static_cast<double>(states.blocks() + states.skipped()) * block_s, header.program,
             header.sample_rate, header.block, header.seed);
  if (states.skipped() > 0)
    fmt::print(stderr, "{}: {:.1f} s of them were skipped, the machine stood still\n", file.string(),
               static_cast<double>(states.skipped()) * block_s);
}

}  // namespace

void add_decode(cli::Verb& program) {
  cli::Verb verb =
      program.verb("decode", "Print what a recorded bus or a session tells the engine").group(kInspect);
  auto options = std::make_shared<DecodeArguments>();
  verb.positional("RIG.toml", options->rig, "the rig; a bus and its signals are enough").required();
  cli::Verb source = verb.exactly_one("Source");
  source.option("--log", options->log.log, kLogHelp);
  source.option("--session", options->session,
                "what rigsoundd --session wrote: what the engine was told; of a folder the newest");
  add_log_options(verb, options->log);
  verb.flag("--json", options->json, "the rows as one JSON document instead of CSV");
  verb.callback([options] { options->session.empty() ? decode_log(*options) : decode_session(*options); });
  verb.details(
      "Prints CSV time_s,signal,value: one row for the first valid value of a signal and one at each change. "
      "time_s counts from the first entry of the log. Values are those after the rig's [safety] rules, in "
      "the "
      "signal's unit, or words (none, closed, open; off, on). Signals of a second boom are NAME.signal. With "
      "one "
      "[[can]] and one interface in the log their names need not agree.\n"
      "Rows `situation` and `feed_deviation` (-1 underfeed, 0 normal, 1 overfeed, and beyond; each time it "
      "has "
      "moved by 0.05) say what the engine makes of a boom's signals. A session has rows of the live "
      "controls, "
      "`output_gain` (mute and fades) and `manual` (the signals that a user holds, or none) too; what "
      "nothing "
      "says any more is `absent`.");
  verb.example("rigsound decode config/rigs/demo.toml --log config/logs/shift.log");
  verb.example("rigsound decode config/rigs/demo.toml --log config/logs/shift.log --json");
  verb.example("rigsound decode config/rigs/demo.toml --session sessions");
}

}  // namespace rigsound::tools
