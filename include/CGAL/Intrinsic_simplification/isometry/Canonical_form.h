// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_CANONICAL_FORM_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_CANONICAL_FORM_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
class Singular_surface;
} // namespace internal

/// What the search for isometries is doing, in this order. A form may begin again from the input:
/// then its stages run again.
enum class Isometry_stage : std::uint8_t {
  flips,         ///< makes a triangulation Delaunay
  flat_vertices, ///< finds flat vertices and removes them
  ties,          ///< joins faces to the polygons of the tessellation
  lengths,       ///< compares lengths, or rounds them
  maps           ///< looks for maps that keep them
};

/// returns what a stage does, in words.
const char* name_of(Isometry_stage stage);

/// How far the search for isometries is.
struct Isometry_progress {
  Isometry_stage stage = Isometry_stage::flips; ///< what it is doing
};

/// What the search for isometries is asked for.
struct Isometry_options {
  /// Is called when a stage begins, and about ten times a second; returns whether to go on.
  std::function<bool(const Isometry_progress&)> progress;
};

/*!
\brief is the Delaunay tessellation of a surface without its flat vertices: polygons with corners at
the vertices with curvature, and at the corners of the border.

It depends on the surface alone, not on the triangulation or the numbering. The vertices, and the
edges that do not separate cocircular faces, are decided exactly. A *dart* is a side of a polygon.
Where a surface with curvature has a loop of its border without a corner, no vertex of the loop is
distinguished: the tessellation is that of two copies of the component, glued along such loops.

A copy shares everything. Two threads must not use copies of one form at a time.
*/
class Canonical_form {
public:
  /// No dart.
  static constexpr std::uint32_t none = Gluing::none;

  /*!
  \brief computes the form of a surface.
  \param surface what `t.shared_input()` returns for a triangulation with correspondence
  \param options what is asked for
  \complexity that of exact Delaunay flips, and of a removal for each flat vertex
  */
  explicit Canonical_form(std::shared_ptr<const Input> surface,
                          const Isometry_options& options = {});
  /// computes the form from a triangulation, which mostly saves its flips if it is Delaunay. The
  /// form may begin again from the input, and starts from there if vertices were inserted.
  explicit Canonical_form(const Corresponding_triangulation& t,
                          const Isometry_options& options = {});

  /// returns `done`, or `cancelled` if `progress` has ended the computation: nothing is known then.
  Status status() const;
  /// tells whether the form depends on the surface alone. Otherwise `note()` says why.
  bool is_unique() const;
  /// says which choice is arbitrary, or what could not be decided; empty if there is nothing.
  std::string note() const;

  /// returns the surface.
  const Input& input() const;
  /// returns the number of flat vertices of the input, which are not in the form.
  std::uint32_t number_of_flat_vertices() const;
  /// returns the number of darts.
  std::uint32_t number_of_darts() const;
  /// returns the next dart of the polygon of `d`, counterclockwise.
  std::uint32_t next(std::uint32_t d) const;
  /// returns the dart on the other side of the edge of `d`, `none` on the border.
  std::uint32_t opposite(std::uint32_t d) const;
  /// returns the vertex of the input from which `d` starts, or of which that vertex is a copy.
  std::uint32_t source(std::uint32_t d) const;
  /// returns the double nearest to the squared length of `d`, in the units of the user.
  /// \throws Invalid_input if exact arithmetic could not decide which one is nearest
  double squared_length(std::uint32_t d) const;

  /*!
  \brief returns a number that is the same for isometric surfaces, mirrored ones included.

  It hashes squared lengths in the units of the user, each rounded correctly, along the
  tessellation.
  Unequal numbers prove that surfaces are not isometric; equal ones prove nothing.
  \param options what is asked for
  \throws Invalid_input if exact arithmetic could not decide the form, or how to round a length, or
    `progress` has ended it
  \complexity linear
  */
  std::uint64_t hash(const Isometry_options& options = {}) const;

  /// \cond
  const std::shared_ptr<const internal::Singular_surface>& shared_parts() const { return parts_; }
  /// \endcond

private:
  std::shared_ptr<const internal::Singular_surface> parts_;
};

/// returns the canonical form of the surface of a triangulation.
/// \tparam Triangulation a triangulation with a correspondence: it keeps its `Input`
template <class Triangulation>
  requires(Triangulation::has_correspondence)
Canonical_form canonical_form(const Triangulation& t, const Isometry_options& options = {}) {
  if constexpr (std::is_same_v<Triangulation, Corresponding_triangulation>)
    return Canonical_form(t, options);
  else
    return Canonical_form(t.shared_input(), options);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_CANONICAL_FORM_H
