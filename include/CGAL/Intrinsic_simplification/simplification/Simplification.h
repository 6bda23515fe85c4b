// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFICATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFICATION_H

#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// What a visitor of `simplify()` gets.
struct Simplify_progress {
  std::size_t removed = 0; ///< vertices, up to now
  std::size_t left = 0;    ///< vertices that are left
};

/// What `simplify()` is asked for. It stops at what is reached first.
struct Simplify_options {
  /// How many vertices are wanted; nothing: as few as possible. On a cover, each copy of a vertex
  /// counts; copies are removed together, so that fewer may be left.
  std::optional<std::size_t> vertices;
  /// The same as a part of the vertices that have faces, above 0 and at most 1; at least one is
  /// wanted. With neither this nor another bound, it is a tenth.
  std::optional<double> part;
  /// No length of a curve is multiplied by more than this, or by less than its inverse; at least 1.
  /// A vertex whose removal would break this stays. Rounding is allowed for: with 1, vertices go
  /// that are flat, or nearly so, with proven bounds that differ from 1 by 1e-9 at most.
  double stretch = std::numeric_limits<double>::infinity();
  /// Vertices whose removal costs more than this stay, in the units of the cost.
  double cost = std::numeric_limits<double>::infinity();
  /// The user's vertices that stay.
  std::vector<std::uint32_t> kept_vertices;
  /// Numbers of edges of the triangulation that stay edges, with their vertices: curves, features.
  std::vector<std::uint32_t> kept_edges;
  /// Is called after every 256 tries to remove a vertex, and returns whether to go on.
  std::function<bool(const Simplify_progress&)> progress;
};

/// By what the lengths of curves are multiplied, from the fine surface to the coarse one. A face so
/// thin that doubles cannot hold its height has no bound: `lower` is 0 or `upper` infinite then. On
/// a cover, curves are on the cover, where copies of a vertex are different points; distances on
/// the mesh, where they are one, may change more.
struct Stretch {
  double lower = 1;      ///< no curve becomes shorter than this times its length: proven
  double upper = 1;      ///< no curve becomes longer than this times its length: proven
  double mean_lower = 1; ///< mean of the lower bounds of faces, by their area on the coarse surface
  double mean_upper = 1; ///< mean of the upper bounds of faces
};

/// Proven bounds in one face, see `Stretch`.
struct Face_stretch {
  double lower = 1; ///< of curves in the face
  double upper = 1; ///< of curves in the face
};

/*!
\brief holds a surface with fewer vertices, and where the vertices of the fine one are on it.
*/
struct Simplification {
  /// `done`: what was asked for is reached; `stalled`: no other vertex can be removed within the
  /// bounds; `cancelled`: by the visitor.
  Status status = Status::done;
  /// The coarse surface: triangles that are glued together, and their squared lengths, doubles that
  /// define it exactly. Triangulations are built of it as of any other; they keep its numbers.
  Intrinsic_input surface;
  /// The user's fine vertex of each coarse vertex.
  std::vector<std::uint32_t> kept;
  /// Where each of the user's fine vertices is on `surface`: at a vertex, or in a face with weights
  /// of its corners. On a cover, where its first copy is. An isolated vertex is at none of them.
  std::vector<Place> places;
  Stretch stretch;                        ///< of all curves
  std::vector<Face_stretch> face_stretch; ///< by the faces of `surface`
  std::size_t removed = 0;                ///< vertices of the fine surface that are gone
  std::size_t newton_steps = 0;           ///< of Newton's method, in all
  unsigned most_newton_steps = 0;         ///< for one vertex
  std::size_t ptolemy_flips = 0;          ///< flips of edges while vertices became flat
  std::size_t flips = 0;                  ///< flips of edges after vertices were removed
  /// Vertices that stay since no proper triangles, without flips of border and kept edges, make
  /// them flat.
  std::size_t blocked_by_border = 0;
  /// Vertices that stay since rounding or loops of edges hindered their removal.
  std::size_t not_flattened = 0;
  /// Vertices that stay since a bound of the stretch or of the cost would be broken.
  std::size_t kept_by_bound = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFICATION_H
