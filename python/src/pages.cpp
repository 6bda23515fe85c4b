// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Faces_in_order.h"
#include "Surface.h"
#include "curve_arrays.h"

#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <three_js.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Pages that show results on surfaces: what Python hands over becomes what `write_html_view()`
// takes.

namespace python {

namespace {

// Numbers at the vertices of the triangulation, or of the user's mesh; or on faces.
struct Values {
  std::string name, place; // "vertices", "faces" of the triangulation, or "input_faces"
  Eigen::VectorXd values;
  bool has_classes = false;
};

// What a page shows, without objects of Python.
struct Contents {
  std::string title, text, marks_name;
  std::vector<Values> fields;
  std::optional<Row_matrix> texture; // a place in the plane for each vertex
  std::vector<IT::Polyline> curves, marks;
  std::vector<IT::Placed_vector> vectors;
  bool is_disk = false, is_logarithm = false, are_arrows = true, has_edges = true;
  unsigned isolines = 0;
};

Contents contents_of(const py::dict& d) {
  Contents c;
  c.title = d["title"].cast<std::string>();
  c.text = d["text"].cast<std::string>();
  c.marks_name = d["marks_name"].cast<std::string>();
  for (const py::handle item : d["fields"]) {
    const auto [name, place, values, has_classes] =
        item.cast<std::tuple<std::string, std::string, Doubles, bool>>();
    c.fields.push_back({name, place, vector_of(values), has_classes});
  }
  if (!d["texture"].is_none()) {
    const auto places = d["texture"].cast<Doubles>();
    expect_columns(places, 2, "an array of places");
    c.texture = matrix_of(places);
  }
  c.curves = polylines_of(d["curves"]);
  c.marks = polylines_of(d["marks"]);
  const auto [places, vectors] = d["vectors"].cast<std::pair<Doubles, Doubles>>();
  const std::vector<Point> from = points_of(places), along = points_of(vectors);
  for (std::size_t i = 0; i < from.size(); ++i) c.vectors.push_back({from[i], along[i]});
  c.is_disk = d["is_disk"].cast<bool>();
  c.is_logarithm = d["is_logarithm"].cast<bool>();
  c.are_arrows = d["are_arrows"].cast<bool>();
  c.has_edges = d["has_edges"].cast<bool>();
  c.isolines = d["isolines"].cast<unsigned>();
  return c;
}

// The scripts of pages: those that were compiled in, or those of this machine.
IT::Three_js scripts() {
  IT::Three_js all{std::string(embedded::three_js()),
                   std::string(embedded::trackball_controls_js())};
  if (all.three.empty() || all.trackball_controls.empty()) all = IT::find_three_js();
  if (all.three.empty() || all.trackball_controls.empty())
    refuse("the page needs three.js; install Debian's package libjs-three");
  return all;
}

// A field on the common subdivision.
// \param face for each face of the subdivision the one with values, if faces have them
IT::Subdivision_field field_of(const Values& f, const IT::Common_subdivision& s,
                               const std::vector<std::int64_t>& face) {
  if (f.place == "vertices") return IT::interpolated_field(f.name, s, f.values, f.has_classes);
  IT::Subdivision_field field{f.name, std::vector<double>(), IT::Subdivision_field::Place::faces};
  for (const std::int64_t i : face) field.values.push_back(f.values[i]);
  field.has_classes = f.has_classes;
  return field;
}

// Writes what there is, on a triangulation.
template <class T>
std::string written(const Contents& c, const T& t, const std::vector<Point>& user_points,
                    double megabytes, Watch& watch) {
  const IT::Three_js three = scripts();
  IT::Common_subdivision s = IT::common_subdivision(t);
  const std::vector<Point> points = IT::positions(s, user_points, t.input());
  IT::label_with_polygons(s, t.input().names().polygon_of_triangle);
  const Faces_in_order order(t);
  std::vector<std::int64_t> mine, users;
  for (const std::uint32_t f : s.intrinsic_face) mine.push_back(order[f]);
  for (const std::uint32_t f : s.input_face) users.push_back(f);
  std::vector<IT::Subdivision_field> fields;
  for (const Values& f : c.fields)
    fields.push_back(field_of(f, s, f.place == "faces" ? mine : users));
  std::vector<std::array<double, 2>> texture;
  if (c.texture) {
    const IT::Subdivision_field u = IT::interpolated_field("u", s, c.texture->col(0)),
                                v = IT::interpolated_field("v", s, c.texture->col(1));
    for (std::size_t i = 0; i < u.values.size(); ++i) texture.push_back({u.values[i], v.values[i]});
  }
  IT::Html_view view;
  view.title = c.title;
  view.description = c.text;
  view.three = three.three;
  view.trackball_controls = three.trackball_controls;
  view.fields = fields;
  view.isolines = c.isolines;
  view.texture = texture;
  view.is_disk = c.is_disk;
  view.is_logarithm = c.is_logarithm;
  view.has_edges = view.has_face_colors = c.has_edges;
  view.curves = c.curves;
  view.vectors = c.vectors;
  view.are_arrows = c.are_arrows;
  view.marks = c.marks;
  view.marks_name = c.marks_name;
  view.maximum_size = static_cast<std::size_t>(1e6 * megabytes);
  std::ostringstream out;
  const IT::Html_view_report report = IT::write_html_view(out, s, points, view);
  if (!report.is_complete()) watch.warn(report.description() + "; megabytes allows a larger page");
  return std::move(out).str();
}

std::string page(Surface& s, const py::dict& contents, double megabytes) {
  if (s.points.empty())
    refuse("the surface has lengths and no points, so that nothing can be drawn");
  const Contents c = contents_of(contents);
  Watch watch;
  return with_triangulation(s, watch,
                            [&](auto& t) { return written(c, t, s.points, megabytes, watch); });
}

} // namespace

void bind_pages(py::module_& m) { m.def("page", &page); }

} // namespace python
