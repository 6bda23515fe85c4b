// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"

#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <pybind11/stl.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Surfaces with numbers, and curves, to files of other programs.

namespace python {

namespace {

using Named_values = std::vector<std::pair<std::string, Doubles>>;

// Writes the common subdivision with numbers at the vertices of the triangulation, or of the mesh.
void save_surface(Surface& s, const std::string& path, const Named_values& given, bool is_plain) {
  if (s.points.empty())
    refuse("the surface has lengths and no points, so that no mesh can be written");
  std::vector<std::pair<std::string, Eigen::VectorXd>> values;
  for (const auto& [name, array] : given) values.emplace_back(name, vector_of(array));
  with_triangulation(s, [&](auto& t) {
    IT::Common_subdivision d = IT::common_subdivision(t);
    const std::vector<Point> points = IT::positions(d, s.points, t.input());
    IT::label_with_polygons(d, t.input().names().polygon_of_triangle);
    std::vector<IT::Subdivision_field> fields;
    for (const auto& [name, x] : values) fields.push_back(IT::interpolated_field(name, d, x));
    if (!is_plain) return IT::write_common_subdivision(path, d, points, fields);
    IT::write_file(path, [&](std::ostream& out) {
      const std::string extension = std::filesystem::path(path).extension().string();
      IT::write_plain_subdivision(out, extension, d, points, fields);
    });
  });
}

void save_curves(const std::string& path, const py::list& curves) {
  IT::write_polylines(path, polylines_of(curves));
}

} // namespace

void bind_files(py::module_& m) {
  m.def("save_surface", &save_surface);
  m.def("save_curves", &save_curves);
}

} // namespace python
