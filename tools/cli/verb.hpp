// A program's command line: verbs, their options, their help. Thread: OFF.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/description.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace rigsound::cli {

/// Wrong usage that only a verb itself can see: ends the program with code 2.
struct UsageError : std::runtime_error {
  UsageError(const std::string& option, const std::string& what) : std::runtime_error(option + ": " + what) {}
};

/// What an option accepts and how its help shows it. A handle: copies mean the same option.
class Option {
 public:
  Option(CLI::Option* option, std::string initial) : option_(option), initial_(std::move(initial)) {}

  Option required();
  Option shows_default();  ///< the value that the variable had when it was added
  Option range(double low, double high, const std::string& unit = {});  ///< of a number, both ends included
  Option at_least(double low, const std::string& unit = {});            ///< of a number
  Option one_of(const std::vector<std::string>& words);
  Option type(const std::string& name);       ///< in the help, instead of TEXT, NUMBER or INTEGER
  Option group(const std::string& heading);   ///< in the help
  Option separated_by_commas();               ///< of a list: also `800,1500`
  Option repeatable();                        ///< of a list: one value each time it is given
  Option count(int values);                   ///< of a list: exactly so many
  Option value_or(const std::string& value);  ///< the name alone means this value
  Option excludes(const Option& other);
  Option needs(const Option& other);

  bool given() const;  ///< once the command line was read

 private:
  CLI::Option* option_;
  std::string initial_;
};

/// The variable that an option's words are read into; it must live as long as the program's command line.
/// A number is refused unless all of its text is one: finite, with a decimal point.
class Target {
 public:
  Target(std::string& value);
  Target(int& value);
  Target(unsigned& value);
  Target(std::uint64_t& value);
  Target(float& value);
  Target(double& value);
  Target(std::optional<std::uint64_t>& value);
  Target(std::vector<std::string>& value);
  Target(std::vector<double>& value);

  enum class Size { kOne, kList };

  const char* type;                               ///< TEXT, NUMBER or INTEGER
  std::string (*fault)(const std::string& word);  ///< what is wrong with a word; empty: nothing
  Size size = Size::kOne;
  std::string initial;                                        ///< the value at first, as text
  std::function<void(const std::vector<std::string>&)> read;  ///< gets words without fault
};

/// The program itself, one of its verbs, or a command of a verb. A handle: copies mean the same verb.
class Verb {
 public:
  explicit Verb(CLI::App* app) : app_(app) {}

  /// A verb, or a command of this verb. `summary` is one imperative line without a full stop. From now on one
  /// must be given, and an unknown one is told with the nearest known.
  Verb verb(const std::string& name, const std::string& summary);
  /// The heading under which the help lists this verb.
  Verb group(const std::string& heading);
  /// Options of the verb that are understood after the names of its commands, too.
  Verb options_anywhere();

  Option positional(const std::string& name, const Target& target, const std::string& help);
  Option option(const std::string& name, const Target& target, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);
  /// A group of options of which exactly one must be given; add them to what this returns.
  Verb exactly_one(const std::string& heading);

  Verb details(
      const std::string& text);  ///< below the options; paragraphs end with a newline, lines are wrapped
  Verb example(const std::string& command_line);
  void callback(std::function<void()> run);

  VerbText description() const;

 private:
  CLI::App* app_;
};

class Program {
 public:
  Program(const std::string& name, const std::string& summary, const std::string& version);
  ~Program();

  Verb verb();

  /// Reads the command line and runs the callback of what it names, whose exceptions pass through.
  /// 0 done, also for --help and --version; 2 wrong usage, told on stderr. The build calls it with the two
  /// words of manual.hpp.
  int run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  std::string version_;
};

}  // namespace rigsound::cli
