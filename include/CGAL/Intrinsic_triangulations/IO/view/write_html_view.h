// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_WRITE_HTML_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_WRITE_HTML_VIEW_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/view/Html_view.h>
#include <CGAL/Intrinsic_triangulations/IO/view/Html_view_writer.h>
#include <CGAL/Intrinsic_triangulations/IO/view/find_three_js.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <array>
#include <ostream>
#include <span>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief writes a page that shows an intrinsic triangulation on the surface: one file that needs no
network.

Intrinsic faces have colours that differ between neighbours, intrinsic edges are dark, input edges
light. A field replaces the colours; a texture darkens every other square of a checkerboard, and is
shown in the plane beside the surface. On a cover, the fronts of the user's faces are shown, or
their backs. Curves and marked points lie on top. The pointer shows the numbers of the faces
under it. In the page, users choose the field, its range and map of colours, the number of isolines,
and a plane that cuts the surface.
\param out the stream
\param s the common subdivision
\param points the position of each vertex, see `positions()`
\param view title, fields, curves
\throws Invalid_input if `points`, a field or the texture do not have one value for each vertex, or
  if three.js is not given and not found
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_html_view(std::ostream& out, const Common_subdivision& s,
                            std::span<const std::array<double, 3>> points, const Html_view& view) {
  internal::check_output({s, points, view.fields});
  for (const Subdivision_field& field : view.fields)
    if (!field.is_function())
      throw Invalid_input(Element_kind::none, 0,
                          "the field \"" + field.name +
                              "\" cannot be shown as colours; give a number per vertex");
  if (!view.texture.empty() && view.texture.size() != s.number_of_vertices())
    throw Invalid_input(Element_kind::none, 0,
                        "the texture has " + std::to_string(view.texture.size()) +
                            " places; give one for each of the " +
                            std::to_string(s.number_of_vertices()) +
                            " vertices of the common subdivision");
  Html_view complete = view;
  const bool has_scripts = !view.three.empty() && !view.trackball_controls.empty();
  const Three_js found = has_scripts ? Three_js() : find_three_js();
  if (view.three.empty()) complete.three = found.three;
  if (view.trackball_controls.empty()) complete.trackball_controls = found.trackball_controls;
  if (complete.three.empty() || complete.trackball_controls.empty())
    throw Invalid_input(Element_kind::none, 0,
                        "the page needs three.js and its TrackballControls.js; install Debian's "
                        "package libjs-three, or give their texts, see find_three_js()");
  internal::Html_view_writer(out, s, points, complete).write();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_WRITE_HTML_VIEW_H
