// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_options.h"

#include <string>
#include <string_view>
#include <vector>

namespace program {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// Text with a backslash before each of some characters.
std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

// A word that the shell takes as it is.
std::string shell_word(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const Described_option& option : described_options(command))
    if (!option.is_positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : described_commands(app)) names.push_back(command->get_name());
  return names;
}

// How `_arguments` of zsh describes an option by one of its names.
std::string zsh_argument(const Described_option& option, const std::string& name) {
  std::string text = "*" + name + "[" + escaped(option.help, "[]\\") + "]";
  if (option.word.empty()) return shell_word(text);
  text += ":" + escaped(option.word, ":\\") + ":";
  return shell_word(text +
                    (option.choices.empty() ? "_files" : "(" + joined(option.choices) + ")"));
}

} // namespace

std::string bash_completion(const CLI::App& app) {
  std::string choices, options;
  for (const CLI::App* command : described_commands(app)) {
    for (const Described_option& option : described_options(*command))
      for (const std::string& name : option.names)
        if (!option.choices.empty())
          choices += "    \"" + command->get_name() + " " + name + "\") words=\"" +
                     joined(option.choices) + "\" ;;\n";
    options += "      " + command->get_name() + ") words=\"" + joined(names_of_options(*command)) +
               "\" ;;\n";
  }
  return "# Completes command lines of intrinsic in bash. Made from the options of the program.\n"
         "_intrinsic() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} words=\"\"\n"
         "  COMPREPLY=()\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    words=\"" +
         joined(names_of_commands(app)) +
         "\"\n"
         "  else\n"
         "    case \"${COMP_WORDS[1]} ${COMP_WORDS[COMP_CWORD - 1]}\" in\n" +
         choices +
         "    esac\n"
         "    if [[ -z $words && $word == -* ]]; then\n"
         "      case ${COMP_WORDS[1]} in\n" +
         options +
         "      esac\n"
         "    fi\n"
         "  fi\n"
         "  [[ -z $words ]] || COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _intrinsic intrinsic # files where there are no words\n";
}

std::string zsh_completion(const CLI::App& app) {
  std::string commands, arguments;
  for (const CLI::App* command : described_commands(app)) {
    commands += "      " +
                shell_word(command->get_name() + ":" + escaped(command->get_description(), "\\")) +
                "\n";
    arguments += "    " + command->get_name() + ")\n      _arguments '1:command:' '*:file:_files'";
    for (const Described_option& option : described_options(*command))
      if (!option.is_positional)
        for (const std::string& name : option.names)
          arguments += " \\\n        " + zsh_argument(option, name);
    arguments += "\n      ;;\n";
  }
  return "#compdef intrinsic\n"
         "# Completes command lines of intrinsic in zsh. Made from the options of the program.\n"
         "_intrinsic() {\n"
         "  if ((CURRENT == 2)); then\n"
         "    local -a commands=(\n" +
         commands +
         "    )\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  case $words[2] in\n" +
         arguments +
         "    *) _files ;;\n"
         "  esac\n"
         "}\n"
         "_intrinsic \"$@\"\n";
}

} // namespace program
