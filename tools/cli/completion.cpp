#include "cli/completion.hpp"

namespace rigsound::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::vector<std::string> verb_names(const VerbText& verb) {
  std::vector<std::string> names;
  for (const VerbText& command : verb.verbs) names.push_back(command.name);
  return names;
}

std::vector<std::string> option_names(const VerbText& verb) {
  std::vector<std::string> names{"--help"};
  for (const OptionText& option : verb.options)
    for (const std::string& name : option.names)
      if (name.rfind("--", 0) == 0 && name != "--help") names.push_back(name);
  return names;
}

/// Words that an option takes, when it takes only some: "a|b|c".
std::string choices(const OptionText& option) {
  if (option.type.find('|') == std::string::npos) return {};
  std::string words = option.type;
  for (char& c : words)
    if (c == '|') c = ' ';
  return words;
}

/// `case` branches of bash: what may follow the verbs given so far.
void add_branches(const VerbText& verb, const std::string& path, std::string& out) {
  out += "    '" + path + "') words='" + joined(verb_names(verb)) + (verb.verbs.empty() ? "" : " ") +
         joined(option_names(verb)) + "' ;;\n";
  for (const VerbText& command : verb.verbs)
    add_branches(command, path.empty() ? command.name : path + " " + command.name, out);
}

void add_choices(const VerbText& verb, std::string& out) {
  for (const OptionText& option : verb.options)
    if (!choices(option).empty())
      out += "    " + option.names.back() + ") words='" + choices(option) + "' ;;\n";
  for (const VerbText& command : verb.verbs) add_choices(command, out);
}

/// Text inside single quotes and square brackets of zsh.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == '[' || c == ']' || c == ':')
      out.append("\\").push_back(c);
    else
      out += c;
  }
  return out;
}

std::string zsh_option(const OptionText& option) {
  const std::string words = choices(option);
  std::string out = "'" + option.names.back() + "[" + zsh_text(option.help) + "]";
  if (!option.type.empty())
    out += words.empty() ? ":" + zsh_text(option.type) + ":_files" : ":word:(" + words + ")";
  return out + "'";
}

void add_zsh_function(const VerbText& verb, const std::string& function, std::string& out) {
  out += function + "() {\n";
  if (!verb.verbs.empty()) {
    out += "  local -a verbs=(\n";
    for (const VerbText& command : verb.verbs)
      out += "    '" + command.name + ":" + zsh_text(command.summary) + "'\n";
    out +=
        "  )\n  if (( CURRENT == 2 )); then _describe verb verbs; return; fi\n  local verb=$words[2]\n"
        "  shift words; (( CURRENT-- ))\n  (( $+functions[" +
        function + "_$verb] )) && " + function + "_$verb\n}\n";
  } else {
    out += "  _arguments";
    for (const OptionText& option : verb.options)
      if (option.names.back().rfind("--", 0) == 0) out += " \\\n    " + zsh_option(option);
    out += " \\\n    '*:file:_files'\n}\n";
  }
  for (const VerbText& command : verb.verbs) add_zsh_function(command, function + "_" + command.name, out);
}

}  // namespace

std::string bash_completion(const VerbText& program) {
  std::string branches, values;
  add_branches(program, "", branches);
  add_choices(program, values);
  return "# bash completion of " + program.name +
         ": verbs, options, words that options take; else files.\n_" + program.name +
         "() {\n  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} path= words= i\n"
         "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         "    [[ ${COMP_WORDS[i]} == -* ]] && break\n"
         "    case \"$path${path:+ }${COMP_WORDS[i]}\" in\n      " +
         [&] {
           std::string paths;
           for (const VerbText& verb : program.verbs) {
             paths += (paths.empty() ? "'" : "|'") + verb.name + "'";
             for (const VerbText& command : verb.verbs) paths += "|'" + verb.name + " " + command.name + "'";
           }
           return paths.empty() ? std::string("''") : paths;
         }() +
         ") path=\"$path${path:+ }${COMP_WORDS[i]}\" ;;\n      *) break ;;\n    esac\n  done\n"
         "  case $path in\n" +
         branches + "  esac\n  case $before in\n" + values +
         "  esac\n  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n}\ncomplete -o default -F _" +
         program.name + " " + program.name + "\n";
}

std::string zsh_completion(const VerbText& program) {
  std::string out = "#compdef " + program.name + "\n";
  add_zsh_function(program, "_" + program.name, out);
  return out + "_" + program.name + " \"$@\"\n";
}

}  // namespace rigsound::cli
