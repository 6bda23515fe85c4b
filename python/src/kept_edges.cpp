// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kept_edges.h"

#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace python {

Kept kept(Surface& s, const std::optional<Integers>& ends, std::optional<double> sharp_angle) {
  Kept k{{}, sharp_angle};
  const std::size_t rows =
      with_triangulation(s, [](auto& t) -> std::size_t { return t.input().number_of_rows(); });
  if (ends) k.ends = numbers_of(*ends, rows, "vertex");
  return k;
}

std::vector<char> marks_of(const IT::Input& input, const Kept& keep) {
  if (keep.ends.empty() && !keep.sharp_angle) return {};
  IT::Input_edges edges(input);
  std::vector<char> marks = edges.no_marks();
  if (keep.sharp_angle && input.metric().points().empty())
    refuse("the surface has lengths and no points, so that no edge is sharp; give keep the edges");
  if (keep.sharp_angle) edges.mark_sharp(*keep.sharp_angle, marks);
  for (std::size_t i = 0; i < keep.ends.size(); i += 2)
    if (!edges.mark(keep.ends[i], keep.ends[i + 1], marks))
      refuse("keep[" + std::to_string(i / 2) + "]: no edge joins vertices " +
             std::to_string(keep.ends[i]) + " and " + std::to_string(keep.ends[i + 1]) +
             "; give a path of edges");
  return marks;
}

} // namespace python
