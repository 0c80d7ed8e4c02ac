#include "cli/verb.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <sstream>

#include "cli/manual.hpp"
#include "cli/number_text.hpp"
#include "rigsound/config/nearest_word.hpp"

namespace rigsound::cli {
namespace {

constexpr std::size_t kColumns = 100;
constexpr const char* kExample = "Example: ";

/// One paragraph a line of `text`, broken at spaces.
std::string wrapped(const std::string& text) {
  std::istringstream paragraphs(text);
  std::string out, paragraph, word;
  while (std::getline(paragraphs, paragraph)) {
    std::istringstream words(paragraph);
    std::string line;
    while (words >> word) {
      if (!line.empty() && line.size() + 1 + word.size() > kColumns) out += line + '\n', line.clear();
      line += (line.empty() ? "" : " ") + word;
    }
    out += line + '\n';
  }
  while (!out.empty() && out.back() == '\n') out.pop_back();
  return out;
}

/// Prints details wrapped, and examples as they stand.
struct HelpFormatter : CLI::Formatter {
  std::string make_footer(const CLI::App* app) const override {
    const std::string footer = app->get_footer();
    const std::size_t examples = std::min(footer.find(kExample), footer.size());
    const std::string text = wrapped(footer.substr(0, examples));
    return footer.empty() ? ""
                          : text + (text.empty() || examples == footer.size() ? "" : "\n\n") +
                                footer.substr(examples) + "\n";
  }
};

std::string text_fault(const std::string&) { return {}; }

/// The one word of `words` into `value`.
template <class Value, class Convert>
auto reader(Value& value, Convert convert) {
  return [&value, convert](const std::vector<std::string>& words) {
    value = static_cast<Value>(convert(words.front()));
  };
}

/// The verb that the command line got to.
const CLI::App& deepest(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : deepest(*parsed.front());
}

/// "unknown KIND WORD, did you mean NEAR?"
std::string unknown(const std::string& kind, const std::string& word, const std::vector<std::string>& known) {
  const std::string near(config::nearest_word(word, known));
  return "unknown " + kind + " " + word + (near.empty() ? "" : ", did you mean " + near + "?");
}

/// Names that an app and its groups of options understand, with their dashes.
void add_option_names(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  for (const CLI::App* part : app.get_subcommands([](const CLI::App*) { return true; }))
    if (part->get_name().empty()) add_option_names(*part, names);
}

/// What is said of the first word that nobody takes: it is no option, or one word too many.
std::string left_over(const CLI::App& app, const std::vector<std::string>& rest) {
  const auto option = std::find_if(rest.begin(), rest.end(), [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  });
  if (option == rest.end()) return "unexpected word " + rest.front();
  std::vector<std::string> known;
  for (const CLI::App* at = &app; at != nullptr; at = at->get_parent()) add_option_names(*at, known);
  return unknown("option", option->substr(0, option->find('=')), known);
}

/// What is said when a verb, a command of one or an option is unknown, or the verb is missing; empty when
/// that is not the fault.
std::string unknown_word(const CLI::App& program) {
  const CLI::App& app = deepest(program);
  const std::vector<std::string> rest = program.remaining(true);
  const bool wants_verb = app.get_require_subcommand_min() > 0;
  const std::string kind = &app == &program ? "verb" : "command";
  if (rest.empty()) return wants_verb ? "expected a " + kind : "";
  if (!wants_verb || rest.front().front() == '-') return left_over(app, rest);
  std::vector<std::string> known;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    known.push_back(verb->get_name());
  return unknown(kind, rest.front(), known);
}

OptionText described(const CLI::Option& option, const std::string& group) {
  OptionText text;
  if (option.get_positional()) text.names.push_back(option.get_name());
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (option.get_expected_max() > 0) text.type = option.get_type_name();
  text.initial = option.get_default_str();
  text.help = option.get_description();
  text.required = option.get_required();
  text.group = group;
  return text;
}

/// Details, then examples, as details() and example() laid them out.
void describe_footer(const std::string& footer, VerbText& text) {
  std::istringstream lines(footer);
  bool examples = false;
  for (std::string line; std::getline(lines, line);) {
    examples = examples || line.rfind(kExample, 0) == 0;
    if (examples)
      text.examples.push_back(line.substr(std::string(kExample).size()));
    else if (!line.empty())
      text.details += line + '\n';
  }
}

VerbText described(const CLI::App& app) {
  VerbText text;
  text.name = app.get_name(), text.summary = app.get_description(), text.heading = app.get_group();
  const auto add_options = [&](const CLI::App& from, const std::string& group) {
    for (const CLI::Option* option : from.get_options())
      (option->get_positional() ? text.positionals : text.options).push_back(described(*option, group));
  };
  add_options(app, "");
  for (const CLI::App* part : app.get_subcommands([](const CLI::App*) { return true; }))
    if (part->get_name().empty())
      add_options(*part, part->get_group());
    else
      text.verbs.push_back(described(*part));
  describe_footer(app.get_footer(), text);
  return text;
}

int usage(const std::string& text) {
  std::fflush(stdout);
  std::fprintf(stderr, "%s\nRun with --help for more information.\n", text.c_str());
  return 2;
}

}  // namespace

Target::Target(std::string& value)
    : type("TEXT"),
      fault(text_fault),
      initial(value),
      read([&value](const std::vector<std::string>& words) { value = words.front(); }) {}
Target::Target(int& value)
    : type("INTEGER"), fault(int32_fault), initial(std::to_string(value)), read(reader(value, integer_of)) {}
Target::Target(unsigned& value)
    : type("INTEGER"), fault(uint32_fault), initial(std::to_string(value)), read(reader(value, integer_of)) {}
Target::Target(std::uint64_t& value)
    : type("INTEGER"),
      fault(uint64_fault),
      initial(std::to_string(value)),
      read(reader(value, unsigned_of)) {}
Target::Target(float& value)
    : type("NUMBER"), fault(number_fault), initial(number_text(value)), read(reader(value, number_of)) {}
Target::Target(double& value)
    : type("NUMBER"), fault(number_fault), initial(number_text(value)), read(reader(value, number_of)) {}
Target::Target(std::optional<std::uint64_t>& value)
    : type("INTEGER"), fault(uint64_fault), read(reader(value, unsigned_of)) {}
Target::Target(std::vector<std::string>& value)
    : type("TEXT"),
      fault(text_fault),
      size(Size::kList),
      read([&value](const std::vector<std::string>& words) { value = words; }) {
  for (const std::string& word : value) initial += (initial.empty() ? "" : ",") + word;
}
Target::Target(std::vector<double>& value)
    : type("NUMBER"), fault(number_fault), size(Size::kList), read([&value](const auto& words) {
        value.clear();
        for (const std::string& word : words) value.push_back(number_of(word));
      }) {}

Option Option::required() {
  option_->required();
  return *this;
}
Option Option::shows_default() {
  option_->default_str(initial_);
  return *this;
}
Option Option::range(double low, double high, const std::string& unit) {
  const std::string accepted =
      number_text(low) + "..." + number_text(high) + (unit.empty() ? "" : " " + unit);
  option_->check(CLI::Validator(
      [=](const std::string& text) { return range_fault(text, low, high, accepted); }, accepted));
  return *this;
}
Option Option::at_least(double low, const std::string& unit) {
  const std::string accepted = number_text(low) + (unit.empty() ? "" : " " + unit) + " or more";
  option_->check(CLI::Validator(
      [=](const std::string& text) {
        return range_fault(text, low, std::numeric_limits<double>::infinity(), accepted);
      },
      accepted));
  return *this;
}
Option Option::one_of(const std::vector<std::string>& words) {
  std::string accepted;
  for (const std::string& word : words) accepted += (accepted.empty() ? "" : "|") + word;
  option_->type_name(accepted);
  option_->check(CLI::Validator(
      [=](const std::string& text) {
        if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
        const std::string near(config::nearest_word(text, words));
        return "is " + text + ", expected " + accepted + (near.empty() ? "" : ", did you mean " + near + "?");
      },
      ""));
  return *this;
}
Option Option::type(const std::string& name) {
  option_->type_name(name);
  return *this;
}
Option Option::group(const std::string& heading) {
  option_->group(heading);
  return *this;
}
Option Option::separated_by_commas() {
  option_->delimiter(',');
  return *this;
}
Option Option::repeatable() {
  option_->allow_extra_args(false);
  return *this;
}
Option Option::count(int values) {
  option_->expected(values);
  return *this;
}
Option Option::value_or(const std::string& value) {
  option_->expected(0, 1)->default_str(value);
  return *this;
}
Option Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}
Option Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}
bool Option::given() const { return option_->count() > 0; }

Verb Verb::verb(const std::string& name, const std::string& summary) {
  app_->require_subcommand(1);
  CLI::App* added = app_->add_subcommand(name, summary);
  added->footer("")->group("Commands")->require_subcommand(0);
  return Verb(added);
}
Verb Verb::group(const std::string& heading) {
  app_->group(heading);
  return *this;
}
Verb Verb::options_anywhere() {
  app_->fallthrough();
  return *this;
}

Option Verb::positional(const std::string& name, const Target& target, const std::string& help) {
  return option(name, target, help);
}

Option Verb::option(const std::string& name, const Target& target, const std::string& help) {
  const auto read = [read = target.read](const CLI::results_t& words) {
    read(words);
    return true;
  };
  CLI::Option* option = app_->add_option(name, CLI::callback_t(read), help);
  option->type_name(target.type)
      ->check(CLI::Validator([fault = target.fault](const std::string& word) { return fault(word); }, ""));
  if (target.size == Target::Size::kList) option->expected(CLI::detail::expected_max_vector_size);
  return Option(option, target.initial);
}

Option Verb::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(app_->add_flag(name, value, help), "");
}

Verb Verb::exactly_one(const std::string& heading) {
  CLI::Option_group* group = app_->add_option_group(heading);
  group->footer("");
  group->require_option(1);
  return Verb(group);
}

Verb Verb::details(const std::string& text) {
  const std::string before = app_->get_footer();
  app_->footer(before + (before.empty() ? "" : "\n") + text);
  return *this;
}

Verb Verb::example(const std::string& command_line) {
  const std::string before = app_->get_footer();
  const bool first = before.find(kExample) == std::string::npos;
  app_->footer(before +
               (before.empty() ? ""
                : first        ? "\n\n"
                               : "\n") +
               (first ? kExample : "         ") + command_line);
  return *this;
}

VerbText Verb::description() const { return described(*app_); }

void Verb::callback(std::function<void()> run) { app_->callback(std::move(run)); }

Program::Program(const std::string& name, const std::string& summary, const std::string& version)
    : app_(std::make_unique<CLI::App>(summary, name)), version_(version) {
  app_->set_version_flag("--version", version);
  app_->formatter(std::make_shared<HelpFormatter>());
}
Program::~Program() = default;

Verb Program::verb() { return Verb(app_.get()); }

int Program::run(int argc, char** argv) {
  try {
    if (argc == 3 && write_manual(verb().description(), version_, argv[1], argv[2])) return 0;
    app_->parse(argc, argv);
    return 0;
  } catch (const UsageError& error) {
    return usage(error.what());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app_->exit(error);
    const std::string unknown = unknown_word(*app_);
    return usage(unknown.empty() ? error.what() : unknown);
  }
}

}  // namespace rigsound::cli
