// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_options.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace program {

namespace {

// Text that `man` shows as it is: a line that begins with a dot or a quote would be a request.
std::string shown(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

// A tagged paragraph: the name of an option in bold, what follows it, and what it does.
std::string paragraph(const Described_option& option) {
  std::string text = ".TP\n";
  for (const std::string& name : option.names)
    text += (&name == &option.names.front() ? "\\fB" : ", \\fB") + shown(name) + "\\fR";
  std::string word = option.word;
  for (const std::string& choice : option.choices)
    word = (&choice == &option.choices.front() ? "" : word + "|") + choice;
  if (!word.empty() && !option.is_positional) text += " \\fI" + shown(word) + "\\fR";
  return text + "\n" + shown(option.help) + "\n";
}

bool is_among(const Described_option& option, const std::vector<Described_option>& options) {
  return std::ranges::any_of(options, [&option](const Described_option& other) {
    return other.names == option.names && other.help == option.help;
  });
}

// The options that all commands have which have any but their help.
std::vector<Described_option> common_options(const std::vector<const CLI::App*>& commands) {
  std::vector<Described_option> shared = described_options(*commands.front());
  for (const CLI::App* command : commands)
    if (const auto own = described_options(*command); own.size() > 1)
      std::erase_if(shared, [&own](const Described_option& o) { return !is_among(o, own); });
  return shared;
}

std::string usage(const CLI::App& command, const std::vector<Described_option>& options) {
  std::string text = "\\fBintrinsic " + shown(command.get_name()) + "\\fR";
  for (const Described_option& option : options)
    if (option.is_positional) text += " \\fI" + shown(option.names.front()) + "\\fR";
  return text + " [\\fIOPTIONS\\fR]\n";
}

std::string section(const std::string& title) { return ".SH " + title + "\n"; }

const std::string head =
    ".SH NAME\n"
    "intrinsic \\- intrinsic triangulations of triangle meshes, with exact predicates\n"
    ".SH SYNOPSIS\n"
    "\\fBintrinsic\\fR \\fICOMMAND\\fR \\fIIN\\fR [\\fIOPTIONS\\fR]\n"
    ".SH DESCRIPTION\n"
    "An intrinsic triangulation keeps the shape of a mesh and changes only its triangles, whose\n"
    "edges are straight paths along the surface. The program makes it Delaunay, refines it, and\n"
    "solves problems on it. Each command reads a mesh and writes the files that its options "
    "name.\n";

const std::string tail =
    ".SH EXIT STATUS\n"
    "0 if all is well, 1 if the input cannot be treated or a file cannot be written, 2 if the\n"
    "command line is wrong. Messages name the element, and the remedy.\n"
    ".SH EXAMPLES\n"
    ".EX\n"
    "intrinsic delaunay part.off \\-o part.ply \\-\\-view part.html\n"
    "intrinsic refine part.off \\-\\-min\\-angle 30 \\-o part.ply \\-\\-laplacian part.mtx\n"
    ".EE\n";

} // namespace

std::string manual_page(const CLI::App& app) {
  const std::vector<const CLI::App*> commands = described_commands(app);
  const std::vector<Described_option> shared = common_options(commands);
  std::string text = ".TH INTRINSIC 1 \"\" \"intrinsic " INTRINSIC_TRIANGULATIONS_VERSION
                     "\" \"User Commands\"\n" +
                     head + section("COMMANDS");
  for (const CLI::App* command : commands)
    text += paragraph({{command->get_name()}, {}, {}, command->get_description(), false});
  text += section("OPTIONS OF ALL COMMANDS");
  for (const Described_option& option : shared) text += paragraph(option);
  text += section("OPTIONS OF EACH COMMAND");
  for (const CLI::App* command : commands) {
    const std::vector<Described_option> options = described_options(*command);
    text += ".SS " + shown(command->get_name()) + "\n" + usage(*command, options);
    for (const Described_option& option : options)
      if (!is_among(option, shared)) text += paragraph(option);
  }
  return text + tail;
}

} // namespace program
