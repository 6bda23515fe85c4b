// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGLE_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGLE_SOUP_H

#include <CGAL/Intrinsic_triangulations/domains/Soup_builder.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <CGAL/number_utils.h>

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief makes a soup of points and faces in arrays.

Polygons are triangulated, and repeated vertices left out, as those of files are, see `read_triangle_soup()`. Nothing else is asked of the faces: `make_domain()`
makes a surface of any.
\tparam PointRange a range of points with `x()`, `y()` and `z()`, or of arrays of three coordinates
\tparam FaceRange a range of ranges of integers: the numbers of the points of each face, in their order around it
\param points the points
\param faces the faces
\param polygons what is made of polygons that are not planar
\throws Invalid_input naming a point with a coordinate that is not finite; or a face with fewer than three points, with
  one that does not exist, with area on two sides of one that occurs twice, or that cannot be triangulated; or if there are no
  faces
\complexity linear for polygons of bounded size
*/
template <class PointRange, class FaceRange>
Triangle_soup triangle_soup(const PointRange& points, const FaceRange& faces,
                            Nonplanar_polygons polygons = Nonplanar_polygons::fan) {
  internal::Soup_builder builder{std::string(), polygons};
  for (const auto& p : points)
    if constexpr (requires { p.x(); })
      builder.add_vertex(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    else
      builder.add_vertex(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
  std::vector<std::int64_t> corners;
  for (const auto& face : faces) {
    corners.clear();
    for (const auto v : face) corners.push_back(static_cast<std::int64_t>(v));
    builder.add_face(corners);
  }
  return builder.finish();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGLE_SOUP_H
