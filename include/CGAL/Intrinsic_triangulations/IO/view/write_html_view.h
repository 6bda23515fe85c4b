// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_WRITE_HTML_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_WRITE_HTML_VIEW_H

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/// A vector in space at a point.
struct Placed_vector {
  std::array<double, 3> place;  ///< the point
  std::array<double, 3> vector; ///< zero or not a number: none
};

/*!
\brief describes what a page shows besides an intrinsic triangulation, and its scripts.
*/
struct Html_view {
  /// Title of the page.
  std::string_view title;
  /// Text under the title.
  std::string_view description;
  /// Text of three.js, revision 111 or near: it is copied into the page, with its licence notice.
  /// Empty: that of `find_three_js()`.
  std::string_view three;
  /// Text of the classic script `TrackballControls.js` of the same distribution. Empty: that of
  /// `find_three_js()`.
  std::string_view trackball_controls;
  /// Fields of numbers at vertices or on faces, one of which is shown as colours at a time.
  std::span<const Subdivision_field> fields{};
  /// Which of the fields is shown at first; none if there are fewer.
  std::size_t shown_field = 0;
  /// How many steps of the field lines of equal value show at first; 0: none.
  unsigned isolines = 0;
  /// A place in the plane for each vertex, shown by a checkerboard; not a number where there is
  /// none. Or empty.
  std::span<const std::array<double, 2>> texture{};
  /// Whether the places are in Poincaré's disk; then triangles with angles of 90, 45 and 36 degrees
  /// that tile it are in place of squares.
  bool is_disk = false;
  /// Whether the places are logarithms of a point, whose place is (0, 0). They are shown up to the
  /// radius at which they tear: where shortest paths from the point arrive on both sides.
  bool is_logarithm = false;
  bool has_edges = true;       ///< whether edges show at first
  bool has_face_colors = true; ///< whether faces without a field have colours at first
  /// Width of curves in pixels.
  double curve_width = 3.5;
  /// Curves on the surface, drawn in the colours of their labels, dark if these are negative. What
  /// is hidden of them shines through.
  std::span<const Polyline> curves{};
  /// The curves before, drawn thin and grey.
  std::span<const Polyline> initial_curves{};
  /// Vectors at points of the surface, those at one point one after another. The page chooses as
  /// many as can be told apart.
  std::span<const Placed_vector> vectors{};
  bool are_arrows = true; ///< whether vectors have heads; else they are lines, such as crosses
  /// Marked points, each a polyline of one point: red where the label is positive, blue where it is
  /// negative, else yellow.
  std::span<const Polyline> marks{};
  /// The name of the marked points.
  std::string_view marks_name = "points";
  /// Most bytes of the page, a million of which are for its scripts. What needs more is thinned
  /// out, see `Html_view_report`.
  std::size_t maximum_size = 30'000'000;
};

/*!
\brief tells what a page shows of all that there is.

Pages have a limit, `Html_view::maximum_size`. Beyond it, vertices in one cell of a grid become one
of them, with its numbers and values, and triangles between others stay. Curves first lose points
that are close to the point before, then some curves are left out. A page has 64 fields, 20,000
marked points and 100,000 vectors at most.
*/
struct Html_view_report {
  std::size_t pieces = 0;       ///< triangles of the common subdivision
  std::size_t shown_pieces = 0; ///< those on the page
  /// Side of the cells in which vertices are one, in units of the points; 0: all are there.
  double cell = 0;
  std::size_t curves = 0;       ///< curves and initial curves with lines
  std::size_t shown_curves = 0; ///< those on the page
  /// How far a point that was left out of a curve may be from one on the page; 0: none was.
  double curve_tolerance = 0;
  std::size_t fields = 0;        ///< fields that were given
  std::size_t shown_fields = 0;  ///< those on the page
  std::size_t marks = 0;         ///< marked points
  std::size_t shown_marks = 0;   ///< those on the page
  std::size_t vectors = 0;       ///< vectors that are not zero
  std::size_t shown_vectors = 0; ///< those on the page

  /// returns whether nothing was left out.
  bool is_complete() const {
    return shown_pieces == pieces && shown_curves == curves && curve_tolerance == 0 &&
           shown_fields == fields && shown_marks == marks && shown_vectors == vectors;
  }
  /// says what was left out, in a line for users; the page has it too.
  std::string description() const;
};

/// The scripts that pages contain.
struct Three_js {
  std::string three;              ///< text of three.js, revision 111 or near
  std::string trackball_controls; ///< text of its classic script `TrackballControls.js`
};

/*!
\brief finds three.js on this machine.
\param directory a directory with `three.min.js` or `build/three.min.js`, and with
  `TrackballControls.js` or `examples/js/controls/TrackballControls.js`; by default that of Debian's
  package libjs-three
\return the texts of both; empty ones if they are not there
*/
Three_js find_three_js(const std::filesystem::path& directory = "/usr/share/javascript/three");

/*!
\brief writes a page that shows an intrinsic triangulation on the surface: one file, readable
without a network.

Intrinsic faces have colours that differ between neighbours, intrinsic edges are dark, input edges
light. A field replaces the colours: a map of colours for numbers, a colour of its own for each
class, and one colour for a constant. A texture darkens every other square of a checkerboard, and
is shown in the plane beside the surface. On a cover, the fronts of the user's faces are shown, or
their backs. Curves, vectors and marked points lie on top. The pointer shows the numbers of the
faces under it. In the page, users choose the field, its range, map of colours and scale, the
number of isolines, which way is up, a plane that cuts the surface, how opaque and smooth it is,
and the size of vectors. At first the surface stands on its largest flat base. If it has none, y is
up, or z if the surface is least high along y. The first view is from where most of the curves and
marked points are seen.
\param out the stream
\param s the common subdivision
\param points the position of each vertex, see `positions()`
\param view title, fields, curves
\return what the page shows; all unless that needs more than `Html_view::maximum_size`
\throws Invalid_input if `points`, a field or the texture do not have one value for each vertex, or
  if three.js is not given and not found
\throws std::runtime_error if the stream fails
\complexity linear; O(n log n) if vertices become one
*/
Html_view_report write_html_view(std::ostream& out, const Common_subdivision& s,
                                 std::span<const std::array<double, 3>> points,
                                 const Html_view& view);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_WRITE_HTML_VIEW_H
