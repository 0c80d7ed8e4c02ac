// The options of every verb that reads a recorded bus.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/verb.hpp"
#include "rigsound/log/bus_log.hpp"

namespace rigsound::tools {

/// What `--log`, `--can` and `--skip-gaps` were given.
struct LogArguments {
  std::string log;
  std::vector<std::string> can;
  double skip_gaps_s = 0;  ///< 0: keep all

  std::optional<double> longest_gap_s() const {
    return skip_gaps_s > 0 ? std::optional<double>(skip_gaps_s) : std::nullopt;
  }
};

constexpr const char* kLogHelp =
    "recorded bus: candump (log or screen), Vector ASC, PEAK TRC, pcap or pcapng of SocketCAN or Modbus/TCP; "
    "gzip "
    "is unpacked; `-`: standard input";

/// `--skip-gaps`.
void add_gap_option(cli::Verb& verb, LogArguments& arguments);
/// `--skip-gaps`, and `--can` from the log's names to the rig's.
void add_log_options(cli::Verb& verb, LogArguments& arguments);

/// Errors: UsageError for a word that is no pair.
log::LogOptions log_options(const LogArguments& arguments);

/// "LOG=OTHER" of `--can`. Errors: UsageError.
std::pair<std::string, std::string> interface_pair(const std::string& word);

}  // namespace rigsound::tools
