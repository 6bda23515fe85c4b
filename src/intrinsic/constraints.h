// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_CONSTRAINTS_H
#define INTRINSIC_CONSTRAINTS_H

#include "options.h"

#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// Coordinates of a vertex.
using Point = std::array<double, 3>;

/// Edges of the input that are never flipped.
struct Constraints {
  IT::Gluing_map mesh; ///< the mesh as it was read; empty if no edge is kept, or it was stored
  std::vector<char> is_constrained; ///< per edge of it, or of the input that is stored
  std::size_t count = 0;
  bool is_stored = false;    ///< whether edges are those of the input of a stored triangulation
  bool is_asked_for = false; ///< whether edges were to be kept, even if there are none
};

/// finds the edges of a mesh that `--sharp-angle` and `--keep` are about.
/// \throws std::runtime_error naming the line of the file that is wrong
Constraints constraints_of(const IT::Intrinsic_input& input, const Options& options);

/// finds those of the input of a stored triangulation.
Constraints constraints_of(const IT::Input& input, const Options& options);

/// Numbers at the edges of a triangulation that are kept: those of curves, or 1; else 0.
template <class Triangulation>
using Edge_labels = IT::Marked_edges<Triangulation, std::uint32_t>;

/// marks the constrained edges of a triangulation, before its first move or as it was stored.
template <class Triangulation>
IT::Marked_edges<Triangulation> marked_edges(const Triangulation& t, const Constraints& c) {
  if (c.count == 0) return IT::Marked_edges<Triangulation>(t);
  if (c.is_stored) return IT::constrained_input_edges(t, c.is_constrained);
  const auto is_constrained = [&c](IT::Gluing_map::Edge e) {
    return c.is_constrained[e.index] != 0;
  };
  return IT::constrained_input_edges(
      t, c.mesh, boost::make_function_property_map<IT::Gluing_map::Edge>(is_constrained));
}

/// labels them with 1.
template <class Triangulation>
Edge_labels<Triangulation> constrained_edges(const Triangulation& t, const Constraints& c) {
  Edge_labels<Triangulation> labels(t);
  if (c.count == 0) return labels;
  const IT::Marked_edges<Triangulation> marks = marked_edges(t, c);
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
    if (get(marks, e)) put(labels, e, 1);
  return labels;
}

} // namespace program

#endif // INTRINSIC_CONSTRAINTS_H
