// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_FIELDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_FIELDS_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/view/page_surface.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

/*!
\file
The fields of a page: their values at its vertices.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// The values of a field for a page: from 0 to 1 in single precision, and their range.
struct Page_field {
  double least = 0, greatest = 0;
  std::vector<float> values;
};

inline bool has_face_fields(std::span<const Subdivision_field> fields) {
  return std::ranges::any_of(fields, [](const Subdivision_field& f) {
    return f.place == Subdivision_field::Place::faces;
  });
}

// At a vertex of the page. One that triangles share has no value of a face; only edges use it.
inline double value_at(const Subdivision_field& field, const Page_surface& surface, std::size_t i) {
  if (field.place == Subdivision_field::Place::vertices) return field.values[surface.vertices[i]];
  const std::size_t shared = surface.vertices.size() - 3 * surface.triangles.size();
  return i < shared ? std::numeric_limits<double>::quiet_NaN()
                    : field.values[surface.polygon[(i - shared) / 3]];
}

// The triangles of the surface are separate if the field has values of faces.
inline Page_field page_field(const Subdivision_field& field, const Page_surface& surface) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const double x : field.values)
    if (std::isfinite(x)) {
      least = std::min(least, x);
      greatest = std::max(greatest, x);
    }
  if (greatest < least) least = greatest = 0;
  Page_field result{least, greatest, {}};
  const double range = greatest / 2 - least / 2; // halves, so that nothing overflows
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    const double x = value_at(field, surface, i);
    result.values.push_back(!std::isfinite(x) ? std::numeric_limits<float>::quiet_NaN()
                            : range > 0       ? static_cast<float>((x / 2 - least / 2) / range)
                                              : 0.f);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_FIELDS_H
