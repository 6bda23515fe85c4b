// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ORIENTATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ORIENTATION_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports whether the faces of a gluing can be oriented consistently, and how.
*/
struct Orientation_result {
  /// Whether the surface is orientable (§2.1 of the course).
  bool is_orientable = true;
  /// If not: a halfedge whose gluing closes a path of faces that reverses orientation.
  std::uint32_t witness = Gluing::none;
  /// If so: nonzero for each face to be reversed, of each component at most half of the faces. The first one of a component is
  /// kept if there are as many of either kind.
  std::vector<char> reversed_faces;
};

/*!
\brief finds out which faces to reverse so that all gluings respect the orientation.
\param g the gluing
\pre `validate(g)` does not throw
\complexity linear
*/
Orientation_result find_orientation(const Gluing& g);

/*!
\brief reverses faces of a gluing so that all gluings respect the orientation, if that is possible.

A reversed face keeps its corner 0; its side `k` becomes side `2 - k`. Which faces: see `Orientation_result`.
\param g the gluing, which is changed only if it is orientable
\return the faces reversed, or a witness that none of the choices works
\pre `validate(g)` does not throw
\complexity linear
*/
Orientation_result orient_faces(Gluing& g);

namespace internal {

// What a face is called in messages: by its number if there are no names.
inline std::uint32_t face_name(std::uint32_t f, const std::vector<std::uint32_t>& names) {
  return names.empty() ? f : names[f];
}

// Reports two faces that run along an edge in the same direction.
[[noreturn]] void fail_orientation(const Gluing& g, std::uint32_t h,
                                   const std::vector<std::uint32_t>& names);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/connectivity/orientation_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ORIENTATION_H
