#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <optional>
#include <utility>

#include "progress_bar.hpp"
#include "record/bus_recorder.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/file/read_files.hpp"
#include "rigsound/machine/input_error.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct RecordArguments {
  std::string rig, out;
  double seconds = 0;
};

FileDescriptor ending_signals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM}) ::sigaddset(&signals, signal);
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);  // before the threads, which inherit it
  return FileDescriptor(::signalfd(-1, &signals, SFD_CLOEXEC));
}

/// Where each kind of bus goes; empty where the rig has none.
struct RecordedFiles {
  std::filesystem::path can, modbus, udp;
};

/// OUT for the first kind that the rig has, a name beside it for the others.
RecordedFiles files_for(const config::Rig& rig, const std::filesystem::path& out) {
  const auto beside = [&out](const char* ending) {
    return std::filesystem::path(out).replace_extension(ending);
  };
  RecordedFiles files;
  if (!rig.can.empty()) files.can = out;
  if (!rig.modbus.empty()) files.modbus = rig.can.empty() ? out : beside(".pcap");
  if (!rig.udp.empty()) files.udp = rig.can.empty() && rig.modbus.empty() ? out : beside(".udp.pcap");
  return files;
}

/// Any name but one that says another format than is written.
void require_log_name(const std::filesystem::path& out, const std::string& ending) {
  for (const char* other : {".asc", ".trc", ".blf", ".mf4", ".gz", ".csv", ".pcapng", ".pcap"})
    if (out.extension() == other && out.extension() != ending)
      throw cli::UsageError(
          "--out", "'" + out.string() +
                       "' names a format that is not written, expected a name that ends in " + ending);
}

std::vector<std::unique_ptr<BusRecorder>> start(const config::Rig& rig, const std::filesystem::path& out) {
  const RecordedFiles files = files_for(rig, out);
  require_apart({files.can, files.modbus, files.udp}, config::files_of(rig));
  require_log_name(out, rig.can.empty() ? ".pcap" : ".log");
  std::vector<std::unique_ptr<BusRecorder>> recorders;
  if (!files.can.empty()) recorders.push_back(record_can(rig, files.can));
  if (!files.modbus.empty()) recorders.push_back(record_modbus(rig, files.modbus));
  if (!files.udp.empty()) recorders.push_back(record_udp(rig, files.udp));
  if (recorders.empty())
    throw InputError(rig.file.string(), "has no bus, expected a [[can]], a [[modbus]] or a [[udp]]");
  return recorders;
}

void record(const RecordArguments& o) {
  const config::Rig rig = config::load_rig(o.rig);
  const FileDescriptor signals = ending_signals();
  const auto recorders = start(rig, o.out);
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(o.seconds);
  pollfd poll{signals.get(), POLLIN, 0};
  std::optional<ProgressBar> bar(std::in_place);
  while (::poll(&poll, 1, 200) == 0 && (o.seconds == 0 || Clock::now() < end)) {
    for (const auto& recorder : recorders) recorder->flush();
    if (o.seconds > 0) bar->show(1 - std::chrono::duration<double>(end - Clock::now()).count() / o.seconds);
  }
  bar.reset();
  for (const auto& recorder : recorders) {
    recorder->flush();
    fmt::print(stderr, "{} entries\n", recorder->entries());
  }
}

}  // namespace

void add_record(cli::Verb& program) {
  cli::Verb verb = program.verb("record", "Record the buses of a rig").group(kRun);
  auto options = std::make_shared<RecordArguments>();
  verb.positional("RIG.toml", options->rig, "the rig whose buses are meant").required();
  verb.option("--out", options->out, "file to write").required();
  verb.option("--seconds", options->seconds, "end after so long; left out: on Ctrl-C").at_least(0.001, "s");
  verb.callback([options] { record(*options); });
  verb.details(
      "CAN is written as candump -l does, all frames of the rig's interfaces; Modbus as a pcap of what was "
      "agreed "
      "between client and server, each link playing the part the rig gives it. UDP as a pcap of its "
      "datagrams. A rig with CAN too writes the Modbus part beside OUT, as OUT with the ending .pcap; one "
      "with other "
      "buses its UDP part with the ending .udp.pcap. A bus that cannot be opened at the start ends it with "
      "3; "
      "one that is lost later is waited for.");
  verb.example("rigsound record config/rigs/demo.toml --out shift.log");
}

}  // namespace rigsound::tools
