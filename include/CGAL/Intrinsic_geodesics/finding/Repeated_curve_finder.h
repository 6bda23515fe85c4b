// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_FINDING_REPEATED_CURVE_FINDER_H
#define CGAL_INTRINSIC_GEODESICS_FINDING_REPEATED_CURVE_FINDER_H

#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/finding/Curve_tools.h>
#include <CGAL/Intrinsic_geodesics/finding/Found_curves.h>
#include <CGAL/Intrinsic_geodesics/finding/Wanted_curve.h>
#include <CGAL/Intrinsic_geodesics/finding/find_curves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Flip_log.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds curves as `find_curves()` does, again and again: nearly as if each time was the first.

It works on a copy of the triangulation, and takes flips back. Where vertices were inserted, for
places inside of faces or where a curve crosses itself, and after trees and Bezier curves, the next
call makes a new copy. Curves are known by their ways over the input: their edges are gone. What the
calls before may change: the last digits of lengths with exact traits, as values become more
accurate; and which face is named for the point that a loop contracts to.
\tparam Triangulation see `find_curves()`
*/
template <GeodesicTriangulation Triangulation>
  requires RefinableTriangulation<Triangulation>
class Repeated_curve_finder {
public:
  /// prepares calls. \param t the triangulation; it must outlive the finder unchanged
  explicit Repeated_curve_finder(const Triangulation& t) : t_(t) {}
  Repeated_curve_finder(const Triangulation&&) = delete;
  Repeated_curve_finder(const Repeated_curve_finder&) = delete;
  Repeated_curve_finder& operator=(const Repeated_curve_finder&) = delete;

  /*!
  \brief finds curves.
  \param wanted the curves
  \param options how to find them
  \throws Invalid_input see `find_curves()`
  \complexity that of `find_curves()`, where no vertices were inserted before without what is linear
    in the mesh
  */
  Found_curves operator()(const std::vector<Wanted_curve>& wanted,
                          const Find_curves_options& options = {}) {
    // an error leaves nothing that could be taken back
    std::unique_ptr<Copy> copy = copy_ ? std::move(copy_) : std::make_unique<Copy>(t_);
    Found_curves found = internal::find_curves_with(copy->tools, wanted, options, {});
    const bool are_flips_known =
        std::all_of(wanted.begin(), wanted.end(), [](const Wanted_curve& c) {
          return c.kind == Curve_kind::geodesic; // others flip without the log
        });
    if (are_flips_known && num_vertices(copy->t.mesh()) == num_vertices(t_.mesh())) {
      copy->take_back();
      copy_ = std::move(copy);
    }
    return found;
  }

private:
  struct Copy {
    explicit Copy(const Triangulation& original) : t(original), tools(t) { tools.log = &log; }
    void take_back() {
      tools.network.clear();
      tools.network.unfix();
      typename Triangulation::Session session(t);
      log.undo(session);
    }

    Triangulation t;
    Flip_log<Triangulation> log;
    internal::Curve_tools<Triangulation> tools;
  };

  const Triangulation& t_;
  std::unique_ptr<Copy> copy_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_FINDING_REPEATED_CURVE_FINDER_H
