// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vertex_sets.h"
#include "../support/text_lines.h"

#include <stdexcept>

namespace program {

void Vertex_sets::refuse(std::size_t set, const std::string& what) const {
  throw std::runtime_error(path + ":" + std::to_string(lines[set]) + ": " + what);
}

Vertex_sets read_vertex_sets(const std::string& path, std::size_t vertices, bool are_pairs) {
  Text_lines lines(path);
  Vertex_sets sets{path, {}, {}};
  while (lines.next()) {
    if (are_pairs) lines.expect_words(2, "the numbers of two vertices");
    std::vector<std::uint32_t>& rows = sets.rows.emplace_back();
    for (std::size_t i = 0; i < lines.words().size(); ++i)
      rows.push_back(lines.element(i, "vertex", vertices));
    sets.lines.push_back(lines.line());
  }
  if (sets.rows.empty())
    throw std::runtime_error(path + ": the file has no vertices; give " +
                             (are_pairs ? "two" : "the sources of a column") + " on each line");
  return sets;
}

} // namespace program
