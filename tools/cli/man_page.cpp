#include "cli/man_page.hpp"

#include <algorithm>
#include <sstream>

namespace rigsound::cli {
namespace {

/// Text that roff prints as it stands.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (out.empty() && (c == '.' || c == '\''))
      out.append("\\&").push_back(c);
    else
      out += c;
  }
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string paragraphs(const std::string& text) {
  std::istringstream in(text);
  std::string out;
  for (std::string line; std::getline(in, line);) out += ".PP\n" + plain(line) + "\n";
  return out;
}

std::string option_lines(const OptionText& option) {
  std::string out = ".TP\n", names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + plain(name);
  out += "\\fB" + names + "\\fR" + (option.type.empty() ? "" : " \\fI" + plain(option.type) + "\\fR") + "\n";
  out += plain(option.help);
  if (!option.initial.empty()) out += " [" + plain(option.initial) + "]";
  if (option.required) out += " (required)";
  if (!option.group.empty()) out += " (exactly one of this group)";
  return out + "\n";
}

std::string option_section(const VerbText& verb, const std::string& heading) {
  std::string out;
  for (const OptionText& option : verb.positionals) out += option_lines(option);
  for (const OptionText& option : verb.options) out += option_lines(option);
  return out.empty() ? out : heading + out;
}

std::string synopsis(const VerbText& verb, const std::string& called) {
  std::string out = "\\fB" + plain(called) + "\\fR";
  for (const OptionText& option : verb.options)
    if (option.required)
      out += " \\fB" + plain(option.names.front()) + "\\fR \\fI" + plain(option.type) + "\\fR";
  if (!verb.options.empty()) out += " [options]";
  if (!verb.verbs.empty()) out += " \\fIcommand\\fR ...";
  for (const OptionText& option : verb.positionals)
    out += option.required ? " \\fI" + plain(option.names.front()) + "\\fR"
                           : " [\\fI" + plain(option.names.front()) + "\\fR]";
  return out + "\n";
}

std::string example_section(const VerbText& verb, const std::string& heading) {
  std::string out;
  for (const std::string& example : verb.examples) out += plain(example) + "\n";
  return out.empty() ? out : heading + ".nf\n" + out + ".fi\n";
}

/// The commands of a verb, on its own page.
std::string command_sections(const VerbText& verb, const std::string& called) {
  std::string out;
  for (const VerbText& command : verb.verbs)
    out += ".SS \"" + plain(called + " " + command.name) + "\"\n" + plain(command.summary) + ".\n.PP\n" +
           synopsis(command, called + " " + command.name) + paragraphs(command.details) +
           option_section(command, "") + example_section(command, ".PP\nExample:\n");
  return out.empty() ? out : ".SH COMMANDS\n" + out;
}

/// The verbs of a program, each on a page of its own.
std::string verb_list(const VerbText& program, const std::string& section) {
  std::string out, heading;
  for (const VerbText& verb : program.verbs) {
    if (verb.heading != heading) out += ".SS " + plain(heading = verb.heading) + "\n";
    out += ".TP\n\\fB" + plain(program.name + "-" + verb.name) + "\\fR(" + section + ")\n" +
           plain(verb.summary) + "\n";
  }
  return out.empty() ? out : ".SH VERBS\n" + out;
}

constexpr const char* kExitCodes =
    ".SH \"EXIT STATUS\"\n"
    ".TP\n0\nDone.\n"
    ".TP\n1\nThe input or the configuration is wrong; one line on standard error says file, line, key and "
    "what was "
    "expected.\n"
    ".TP\n2\nWrong usage.\n"
    ".TP\n3\nThe machine failed: a device, a disk, a bus.\n";

// A user's command; the daemon ends with 0 when it is told to.
constexpr const char* kSignalCodes =
    ".TP\n128 + N\nSignal N ended it: 130 on Ctrl-C. Nothing half made is left.\n";

struct Setting {
  std::string version, section;
};

std::string page(const VerbText& verb, const std::string& name, const std::string& called,
                 const std::string& middle, const Setting& setting) {
  std::string out = ".TH \"" + upper(name) + "\" " + setting.section + " \"\" \"rigsound " + setting.version +
                    "\" \"rigsound\"\n.SH NAME\n" + plain(name) + " \\- " + plain(verb.summary) +
                    "\n.SH SYNOPSIS\n" + synopsis(verb, called);
  if (!verb.details.empty()) out += ".SH DESCRIPTION\n" + paragraphs(verb.details);
  return out + option_section(verb, ".SH OPTIONS\n") + middle + example_section(verb, ".SH EXAMPLES\n") +
         kExitCodes + (setting.section == "1" ? kSignalCodes : "");
}

std::string file_name(const std::string& page, const std::string& section) { return page + "." + section; }

}  // namespace

std::vector<Page> man_pages(const VerbText& program, const std::string& version, const std::string& section) {
  const Setting setting{version, section};
  std::vector<Page> pages{{file_name(program.name, section),
                           page(program, program.name, program.name, verb_list(program, section), setting)}};
  for (const VerbText& verb : program.verbs) {
    const std::string name = program.name + "-" + verb.name, called = program.name + " " + verb.name;
    pages.push_back(
        {file_name(name, section), page(verb, name, called, command_sections(verb, called), setting)});
  }
  return pages;
}

}  // namespace rigsound::cli
