// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Faces_in_order.h"
#include "Surface.h"

#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

// What the subdivision is in arrays, before the interpreter's lock is back.
struct Subdivision {
  IT::Common_subdivision s;
  std::vector<Point> points;
  std::vector<std::int64_t> intrinsic_face;
  IT::Interpolation_matrix from_input, from_intrinsic;
};

py::dict common_subdivision(Surface& s, Watch& watch) {
  Subdivision d = with_triangulation(s, watch, [&](auto& t) {
    Subdivision r{IT::common_subdivision(t), {}, {}, {}, {}};
    watch.begin("matrices");
    r.from_input = IT::interpolation_from_input(r.s);
    r.from_intrinsic = IT::interpolation_from_intrinsic(r.s);
    watch.begin("places");
    const Faces_in_order order(t);
    for (const std::uint32_t f : r.s.intrinsic_face) r.intrinsic_face.push_back(order[f]);
    IT::label_with_polygons(r.s, t.input().names().polygon_of_triangle);
    if (!s.points.empty()) r.points = IT::positions(r.s, s.points, t.input());
    return r;
  });
  py::dict result;
  result["has_points"] = !d.points.empty();
  result["points"] = array_of(std::move(d.points));
  result["corners"] = whole(d.s.corner);
  result["begins"] = whole(d.s.face_begin);
  result["input_face"] = whole(d.s.input_face);
  result["intrinsic_face"] = array_of(std::move(d.intrinsic_face));
  result["sheet"] = whole(d.s.sheet);
  result["P_input"] = array_of(std::move(d.from_input));
  result["P_intrinsic"] = array_of(std::move(d.from_intrinsic));
  return result;
}

// Values at vertices on the other triangulation, a function per column.
py::array_t<double> transfer(Surface& s, const Doubles& values, bool to_input, bool is_l2,
                             Watch& watch) {
  const Row_matrix given = matrix_of(values);
  return array_of(with_triangulation(s, watch, [&](auto& t) -> Row_matrix {
    if (!is_l2) return to_input ? IT::copy_to_input(t, given) : IT::copy_to_intrinsic(t, given);
    const Eigen::MatrixXd columns = given;
    const auto make = [&] {
      const IT::Common_subdivision subdivision = IT::common_subdivision(t);
      watch.begin("factorization");
      return new IT::L2_transfer(t, subdivision,
                                 to_input ? IT::Transfer_direction::to_input
                                          : IT::Transfer_direction::to_intrinsic);
    };
    auto& nearest = s.cached<IT::L2_transfer>(to_input ? "to_input" : "from_input", make);
    watch.begin("solution");
    return nearest(columns);
  }));
}

} // namespace

void bind_subdivision(py::module_& m) {
  m.def("common_subdivision", &common_subdivision);
  m.def("transfer", &transfer);
}

} // namespace python
