// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "summary.h"
#include "answers.h"
#include "support/input_name.h"
#include "support/messages.h"
#include "support/progress.h"
#include "support/warnings.h"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace program {

namespace {

// Begins a line of the summary.
std::ostream& row(std::ostream& out, std::string_view title) {
  constexpr std::size_t width = 16;
  return out << title << std::string(title.size() < width ? width - title.size() : 1, ' ');
}

void print_line(std::ostream& out, const Answer_line& line, const Figures& figures) {
  if (line.is_shown != nullptr && !line.is_shown(figures)) return;
  if (const auto text = figures.fill(line.text)) row(out, line.title) << *text << '\n';
}

// Prints the lines of the surface that are not in the answer.
void print_surface(std::ostream& out, const std::vector<Answer_line>& answer,
                   const Figures& figures) {
  for (const Answer_line& line : lines_of_surface())
    if (std::ranges::count(answer, line.text, &Answer_line::text) == 0)
      print_line(out, line, figures);
}

void print_seconds(std::ostream& out, const Json& json) {
  row(out, "seconds");
  const char* separator = "";
  for (const auto& [what, seconds] : json["seconds"].items()) {
    out << separator << what << ' ' << seconds.get<double>();
    separator = ", ";
  }
  out << "; at most " << json["peak_rss_mib"].get<double>() << " MiB of memory\n";
}

} // namespace

std::ostream& answer_stream(const Options& options) {
  for (const Output& output : outputs(options))
    if (is_standard_output(output.path)) return std::cerr;
  return std::cout;
}

void print_answer(const Json& json, const Options& options,
                  const std::vector<std::string>& written) {
  if (options.is_quiet) return;
  const Figures figures(json);
  std::ostringstream out; // the stream keeps its format
  const std::vector<Answer_line>& answer = answer_of(options.command);
  for (const Answer_line& line : answer) print_line(out, line, figures);
  if (options.is_verbose) {
    print_surface(out, answer, figures);
    print_seconds(out, json);
  }
  for (const Output& output : outputs(options))
    for (const std::string& path : written)
      if (path == output.path && !is_standard_output(path))
        row(out, "written") << path << ": " << output.contents << '\n';
  clear_progress_line();
  std::ostream& stream = answer_stream(options);
  if (!(stream << legible(out.str()) << std::flush))
    throw std::runtime_error("standard output cannot be written; is the disk full?");
}

void print_warnings(const Options& options) {
  for (const std::string& warning : take_warnings())
    if (!options.is_quiet)
      std::cerr << legible(with_input_named(options.input + ": warning: " + warning)) << '\n';
}

} // namespace program
