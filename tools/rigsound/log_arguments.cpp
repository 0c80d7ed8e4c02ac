#include "log_arguments.hpp"

namespace rigsound::tools {

void add_gap_option(cli::Verb& verb, LogArguments& arguments) {
  verb.option("--skip-gaps", arguments.skip_gaps_s, "leave out pauses of the log longer than this")
      .at_least(0.001, "s");
}

void add_log_options(cli::Verb& verb, LogArguments& arguments) {
  verb.option("--can", arguments.can,
              "LOG=RIG: what the log calls interface LOG is the rig's RIG; once for each interface")
      .repeatable();
  add_gap_option(verb, arguments);
}

log::LogOptions log_options(const LogArguments& arguments) {
  log::LogOptions options;
  options.longest_gap_s = arguments.longest_gap_s();
  for (const std::string& word : arguments.can) options.interfaces.push_back(interface_pair(word));
  return options;
}

std::pair<std::string, std::string> interface_pair(const std::string& word) {
  const std::size_t sign = word.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == word.size())
    throw cli::UsageError("--can", "'" + word + "' is no pair, expected one like can0=vcan3");
  return {word.substr(0, sign), word.substr(sign + 1)};
}

}  // namespace rigsound::tools
