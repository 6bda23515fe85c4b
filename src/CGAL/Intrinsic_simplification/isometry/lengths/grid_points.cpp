// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/lengths/Chart_grid.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>

#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

std::optional<Grid_point> Developed_faces::grid_point(Point p) const {
  if (p >= number_of_halfedges()) return images_[p - number_of_halfedges()].grid_point;
  return charts_.grid_point(charts_.number_of_point(p));
}

std::optional<Grid_point> Developed_faces::grid_point(const Image& i) const {
  const Plane_motion* m = maps_.motion_or_null(i.map);
  const Chart_grid* grid = m == nullptr ? nullptr : charts_.grid(m->chart);
  if (grid == nullptr) return std::nullopt;
  const Plane_number& z = charts_.point(charts_.number_of_point(i.start));
  const Plane_number w = product(m->turn, z, charts_.squared_area(m->chart)) + m->shift;
  return grid->point(grid->coordinates(w));
}

} // namespace CGAL::Intrinsic_triangulations::internal
