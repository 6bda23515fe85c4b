// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FIND_ISOMETRIES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FIND_ISOMETRIES_H

#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// Whether two surfaces are isometric.
enum class Isometry_answer {
  isometric,        ///< they are, by proof
  isometric_within, ///< lengths differ a little, as if by rounding; see `largest_difference()`
  not_isometric,    ///< they are not, by proof
  undecided         ///< `Isometries::note()` says why
};

/// returns the name of an answer.
const char* name_of(Isometry_answer answer);

namespace internal {
class Isometry_search;
} // namespace internal

/*!
\brief maps a surface to another one, or to itself, and keeps all lengths.

It maps darts of canonical forms exactly, and points in doubles.
*/
class Isometry {
public:
  /// tells whether a part of the surface is mapped to its mirror image.
  bool reverses_orientation() const;
  /// returns the dart to which a dart is mapped. If the polygon is mirrored, the image runs against
  /// the direction of the dart.
  std::uint32_t image_of_dart(std::uint32_t dart) const { return image_[dart]; }
  /// tells whether the polygon of a dart is mapped to its mirror image.
  bool is_mirrored(std::uint32_t dart) const { return is_mirrored_[dart] != 0; }
  /// returns the vertex of the other input to which a vertex is mapped, or `Canonical_form::none`
  /// if it is flat.
  std::uint32_t image_of_vertex(std::uint32_t vertex) const { return vertices_[vertex]; }
  /// maps points of the input of the first surface to points of the input of the second one.
  /// \complexity that of locating the points, and a pass over the removals of flat vertices
  std::vector<Surface_point> images_of(std::span<const Surface_point> points) const;

private:
  friend class internal::Isometry_search;
  Isometry(std::shared_ptr<const internal::Isometry_search> search, std::size_t number);

  std::shared_ptr<const internal::Isometry_search> search_;
  std::vector<std::uint32_t> image_, vertices_;
  std::vector<char> is_mirrored_;
};

/*!
\brief holds the answer whether two surfaces are isometric, and all isometries.
*/
class Isometries {
public:
  /// returns the answer.
  Isometry_answer answer() const;
  /// returns the number of isometries, infinity if it exceeds all doubles; those of
  /// `isometric_within` are up to the difference. Where a continuous group moves the surface,
  /// isometries are counted up to it, and `note()` names it.
  double count() const;
  /// returns the number of isometries that `operator[]` returns: all, or 2^32 of more.
  std::size_t size() const;
  /// computes isometry number `i`. \complexity linear in the number of darts
  Isometry operator[](std::size_t i) const;
  /// returns the largest relative difference of the lengths of corresponding edges: zero if the
  /// surfaces are isometric, a bound for isometry number 0 if they are `isometric_within`, infinity
  /// otherwise.
  double largest_difference() const;
  /// names the continuous part of the group, says that covers are compared, that mollification has
  /// changed lengths, or why nothing was decided; mostly empty.
  std::string note() const;
  /// returns the number of candidates that were compared with the surface, for tests and
  /// benchmarks.
  std::size_t number_of_walks() const;

private:
  friend Isometries find_isometries(const Canonical_form& a, const Canonical_form& b,
                                    const Isometry_options& options);
  explicit Isometries(std::shared_ptr<const internal::Isometry_search> search)
      : search_(std::move(search)) {}

  std::shared_ptr<const internal::Isometry_search> search_;
};

/*!
\brief finds all isometries from a surface to another one, mirror images included.

<b>Method.</b> The Delaunay tessellations of isometric surfaces are the same. Darts are the states
of an automaton, with the letters *next* and *opposite*. Hopcroft's algorithm finds the darts that
no word of letters tells apart. One dart of each component is compared with all darts that are left
to it; a walk over the tessellation verifies each, and those that follow from others by symmetry are
not walked again.

Squared lengths of both surfaces are compared exactly, in the field of the square roots of both.
\param a the first surface
\param b the second surface, or the first one again: then these are the symmetries
\param options what is asked for; if `progress` ends the search, the answer is `undecided`
\complexity O(n log n) for n darts, and a walk for each candidate
*/
Isometries find_isometries(const Canonical_form& a, const Canonical_form& b,
                           const Isometry_options& options = {});

/// finds the isometries between the surfaces of two triangulations, see above.
/// \tparam First, Second triangulations with a correspondence
template <class First, class Second>
  requires(First::has_correspondence&& Second::has_correspondence)
Isometries find_isometries(const First& a, const Second& b, const Isometry_options& options = {}) {
  return find_isometries(canonical_form(a, options), canonical_form(b, options), options);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FIND_ISOMETRIES_H
