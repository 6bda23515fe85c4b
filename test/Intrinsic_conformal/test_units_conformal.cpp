// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_conformal.h>
#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_operators.h>
#include <CGAL/Intrinsic_operators/distance/curve_sources.h>
#include <CGAL/Intrinsic_operators/operators/surface_modes.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/extrinsic/extrinsic_delaunay.h>

#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Whatever has a unit is in the user's: on a surface that is 2^30 times as large or as small,
// results are those on the surface times a power of that, bit for bit, since the library computes
// in units that are powers of two. `test/check_units.py` says which functions are here.

namespace {

using namespace operator_test;
using T = IT::Corresponding_triangulation;
using Complex = std::complex<double>;
using Points = std::vector<std::array<double, 3>>;

// Numbers that are in so many units of length, and how far they may be off.
struct Found {
  std::string what;
  int power;
  std::vector<double> values;
  double tolerance;
};

template <class X>
void append(std::vector<double>& to, const X& x) {
  if constexpr (std::is_arithmetic_v<X>)
    to.push_back(static_cast<double>(x));
  else if constexpr (requires { x.outerSize(); }) {
    for (Eigen::Index k = 0; k < x.outerSize(); ++k)
      for (typename X::InnerIterator i(x, k); i; ++i) append(to, i.value());
  } else if constexpr (requires { x.real(); })
    for (const double y : {x.real(), x.imag()}) to.push_back(y);
  else
    for (const auto& y : x) append(to, y);
}

class Results {
public:
  template <class X>
  void add(const std::string& what, int power, const X& x, double tolerance = 0) {
    append(found.emplace_back(Found{what, power, {}, tolerance}).values, x);
  }
  std::vector<Found> found;
};

Shape times(Shape s, double unit) {
  for (auto& p : s.points)
    for (double& x : p) x *= unit;
  return s;
}

// A surface, and its Delaunay triangulation.
struct Sized {
  Sized(const Shape& s, double u) : unit(u), shape(times(s, u)), t(shape.input()) {
    IT::flip_to_delaunay(t);
  }
  T::vertex_descriptor vertex(std::uint32_t row) const { return IT::vertex_of_row(t, row); }
  std::vector<double> heights() const {
    std::vector<double> result;
    for (const auto& p : shape.points) result.push_back(p[0] / unit + 0.1 * p[2] / unit);
    return result;
  }
  IT::Surface_point point(std::uint32_t f, double a, double b) const {
    return {t.input().halfedge_of_face(f), {1 - a - b, a, b}};
  }
  double unit;
  Shape shape;
  T t;
};

void expect_powers(const Shape& shape, void (*find)(Sized&, Results&)) {
  Results one;
  Sized x(shape, 1);
  find(x, one);
  for (const int exponent : {-30, 30}) {
    Results other;
    Sized y(shape, std::ldexp(1, exponent));
    find(y, other);
    ASSERT_EQ(one.found.size(), other.found.size());
    for (std::size_t i = 0; i < one.found.size(); ++i) {
      const auto& [what, power, a, tolerance] = one.found[i];
      const std::vector<double>& b = other.found[i].values;
      SCOPED_TRACE(what + " at 2^" + std::to_string(exponent));
      ASSERT_EQ(a.size(), b.size());
      EXPECT_FALSE(a.empty());
      for (std::size_t k = 0; k < a.size(); ++k) {
        const double expected = std::ldexp(a[k], power * exponent);
        if (tolerance == 0)
          EXPECT_EQ(b[k], expected);
        else
          EXPECT_NEAR(std::ldexp(b[k], -power * exponent), a[k], tolerance);
      }
    }
  }
}

Shape hills() { return rough_grid(6, .3, .5, 3); }

TEST(Units_of_results, of_measures_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    std::vector<double> lengths, bounds, areas;
    for (const auto e : edges(x.t.mesh())) {
      lengths.push_back(x.t.length(e));
      bounds.push_back(IT::length_enclosure(x.t, e).sup());
    }
    for (const auto f : faces(x.t.mesh())) areas.push_back(x.t.area(f));
    r.add("length", 1, lengths);
    r.add("length_enclosure", 1, bounds);
    r.add("area", 2, areas);
    r.add("total_area", 2, std::array{IT::total_area(x.t), IT::stored_area(x.t)});
    r.add("area_of_points", 2,
          std::array{IT::area_of_points(x.t), IT::area_of_points(x.t, x.shape.points)});
    const Points& p = x.shape.points;
    r.add("area_in_space", 2, std::array{IT::area_in_space(p[0], p[8], p[9])});
    r.add("odt_energy", 4, std::array{IT::odt_energy(x.t)});
    const IT::Marked_edges<T, std::uint32_t> none(x.t);
    const IT::Measurements m = IT::measure(x.t, none, x.shape.points);
    r.add("measure_shapes, area", 2, std::array{IT::measure_shapes(x.t, none).area});
    r.add("measure, area", 2, std::array{m.area});
    r.add("measure, trace", 0, std::array{m.laplacian_trace});
    r.add("measure, dirichlet", 2, m.dirichlet.value());
    r.add("gaussian_curvature", 0, std::array{IT::gaussian_curvature(x.t, x.vertex(24))});
    const auto e = edge(halfedge(x.vertex(24), x.t.mesh()), x.t.mesh());
    r.add("cotangent_weight", 0, std::array{IT::cotangent_weight(x.t, e)});
  });
}

TEST(Units_of_results, of_other_metrics_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    const IT::Intrinsic_input in = x.shape.input();
    r.add("scale_conformally", 2, IT::scale_conformally(in, [](auto v) {
                                    return 0.01 * (v.index % 5);
                                  }).input.squared_lengths);
    std::vector<double> asked;
    const IT::Scaled_metric scaled = IT::scale_by_norm(in, [&](auto, const IT::Unscaled_vector& v) {
      append(asked, std::array{v.x, v.y});
      return 2 * std::hypot(v.x, 1.1 * v.y);
    });
    r.add("scale_by_norm, vectors", 1, asked);
    r.add("scale_by_norm", 2, scaled.input.squared_lengths);
    r.add("scale_by_norm_in_space", 2,
          IT::scale_by_norm_in_space(in, [](auto, const std::array<double, 3>& v) {
            return std::hypot(v[0], v[1], 1.1 * v[2]);
          }).input.squared_lengths);
    std::vector<double> squares = scaled.input.squared_lengths;
    squares[5] *= 9;
    IT::shorten_edges(in.mesh, squares, 0.01);
    r.add("shorten_edges", 2, squares);

    Points sides;
    for (const auto& f : x.shape.triangles) {
      sides.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        sides.back()[k] = (x.shape.point(f[k]) - x.shape.point(f[(k + 1) % 3])).norm();
    }
    const auto n = static_cast<std::uint32_t>(x.shape.points.size());
    r.add("make_domain", 2,
          std::array{IT::total_area(T(IT::make_domain(n, x.shape.triangles, sides).input))});
    r.add("make_point_cloud", 2,
          std::array{IT::total_area(T(IT::make_point_cloud(x.shape.points, 12).input))});
    r.add("ideal_start", 2, IT::ideal_start(x.t).squared_lengths);
    r.add("points_of_rows", 1, IT::points_of_rows(x.t, x.shape.points));
    r.add("positions", 1, IT::positions(IT::common_subdivision(x.t), x.shape.points));
    r.add("extrinsic_delaunay", 1, IT::extrinsic_delaunay(mesh_of<Surface_mesh>(x.shape)).points);
  });
}

TEST(Units_of_results, of_improvements_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    T refined(x.t), adapted(x.t);
    IT::Improve_options options;
    options.refine.emplace(IT::Refine_criteria{
        .minimum_angle = 25, .lengths = std::vector(x.shape.points.size(), 0.7 * x.unit)});
    const IT::Improvement done = IT::improve(refined, options);
    r.add("Refine_criteria", 0, std::array{refined.number_of_vertices()});
    r.add("area_before", 2, std::array{done.area_before});
    options.refine.reset();
    options.adapt.emplace(IT::Adapt_criteria{.source = 24, .tolerance = 0.05});
    const IT::Improvement also = IT::improve(adapted, options);
    r.add("Adapted_faces, unit", 1, std::array{also.adapted->unit});
    r.add("Adapted_faces, error", 1,
          std::array{also.adapted->result.rounds.back().estimated_error});
    const T mollified(x.shape.input(IT::Mollification::lengths));
    const IT::Mollification_report& report = mollified.report().mollification;
    r.add("Mollification_report", 1, std::array{report.delta});
  });
}

TEST(Units_of_results, of_distances_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    const std::vector sets{std::vector{x.vertex(8)}, std::vector{x.vertex(30), x.vertex(12)}};
    std::vector<double> out(2 * x.shape.points.size());
    IT::polyhedral_distances(x.t, sets, std::span<double>(out));
    r.add("polyhedral_distances", 1, out);
    IT::heat_distances(x.t, sets, std::span<double>(out));
    r.add("heat_distances", 1, out);
    const IT::Found_distances found =
        IT::distances(x.t, {IT::Place::at_vertex(8)}, {.maximum_distance = 2 * x.unit});
    std::vector<double> near;
    for (const double d : found.by_row) append(near, std::isfinite(d) ? d : 0);
    r.add("distances", 1, near);
    r.add("pair_distances", 1, IT::pair_distances(x.t, sets[1], {x.vertex(3), x.vertex(41)}));
    IT::Polyhedral_distance distance(x.t, x.vertex(8));
    r.add("farthest_points", 1, std::array{IT::farthest_points(distance, 4).radius});
    const auto h = halfedge(x.vertex(24), x.t.mesh());
    const std::vector curve{h, next(h, x.t.mesh())};
    r.add("Signed_heat_distance", 1, IT::Signed_heat_distance(x.t).distances(curve));
    r.add("edge_sources", 1, IT::Signed_heat_distance(x.t).distances(IT::edge_sources(x.t, curve)));
    const std::vector places{IT::Place::in_face(3, {.2, .5, .3}),
                             IT::Place::in_face(3, {.6, .1, .3})};
    const IT::Traced_curve line = IT::curve_through(x.t, places);
    r.add("polyline_sources", 1,
          IT::Signed_heat_distance(x.t).distances(IT::polyline_sources(x.t, line)));
  });
}

TEST(Units_of_results, of_curves_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    IT::Geodesic_finder find(x.t);
    const IT::Geodesic_path path = find(x.vertex(2), x.vertex(45));
    r.add("Geodesic_finder", 1,
          std::array{path.length, path.initial_length, path.length_enclosure.inf()});
    r.add("point_on_curve", 0, IT::point_on_curve(x.t, path, 0.3).weights);
    const std::vector control{x.point(2, .2, .3), x.point(40, .3, .3), x.point(60, .5, .1)};
    r.add("bezier_point", 0, IT::bezier_point(x.t, find, control, 0.4).point.weights);
    r.add("traced_curve", 1,
          std::array{IT::traced_curve(x.t.input(), IT::trace_geodesic_on_input(
                                                       x.t, control[0], {0.6, 0.8}, 2 * x.unit))
                         .length});
    const auto lines = IT::isolines(x.t, x.heights(), std::array{2.2, 3.7});
    r.add("polylines of isolines", 1, IT::polylines(x.t, lines, x.shape.points).front().points);
    for (const IT::Traced_isoline& line : IT::trace_isolines(x.t, lines))
      r.add("trace_isolines", 1, std::array{line.curve.length});
    T with_lines(x.t);
    r.add("insert_isolines, cut_along", 1,
          IT::positions(IT::cut_along(with_lines, IT::insert_isolines(with_lines, lines)),
                        x.shape.points));
    const IT::Wanted_curve wanted{{IT::Place::at_vertex(9), IT::Place::in_face(50, {.2, .3, .5})}};
    T with_curve(x.t);
    const auto found = IT::find_curves(with_curve, {wanted});
    r.add("find_curves", 1, std::array{found.curves[0].way.length, found.curves[0].initial_length});
    r.add("polylines", 1, IT::polylines(with_curve, found, x.shape.points)[0].points);
    T with_bezier(x.t);
    r.add("make_bezier_curve", 1,
          std::array{IT::make_bezier_curve(with_bezier, {x.vertex(8), x.vertex(26), x.vertex(12)},
                                           IT::parameters::tolerance(0.05 * x.unit))
                         .length});
  });
}

TEST(Units_of_results, of_matrices_and_functions_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    r.add("voronoi_mass_matrix", 2, IT::voronoi_mass_matrix(x.t));
    r.add("quadratic_laplacian", 0, IT::quadratic_laplacian(x.t));
    r.add("hodge_star_1", 0, IT::hodge_star_1(x.t));
    r.add("connection_laplacian", 0, IT::connection_laplacian(x.t));
    r.add("edge_connection_laplacian", 0, IT::edge_connection_laplacian(x.t));
    r.add("transport_along_halfedges", 0, IT::transport_along_halfedges(x.t));
    // Eigenvalues are found up to rounding, relative to the largest.
    r.add("surface_modes", -2, IT::surface_modes(x.t, 4).values, 1e-9);
    const Eigen::VectorXd load = IT::lumped_mass_matrix(x.t).diagonal();
    r.add("solve_reaction_diffusion", 0,
          IT::solve_reaction_diffusion(x.t, {.diffusion = 0.1 * x.unit * x.unit, .reaction = 1},
                                       load));
    const std::array<std::uint32_t, 3> rows{3, 20, 40};
    r.add("interpolate_harmonically", 0,
          IT::interpolate_harmonically(x.t, rows, Eigen::Vector3d(1, 2, 4)));
    const std::vector<double> heights = x.heights();
    const Eigen::MatrixXd values =
        Eigen::Map<const Eigen::VectorXd>(heights.data(), std::ssize(heights));
    r.add("Heat_flow", 0, IT::Heat_flow(x.t, 0.2 * x.unit * x.unit).step(values));
    r.add("Surface_deformation", 1,
          IT::Surface_deformation(x.t, rows).displacements(x.unit * Eigen::Matrix3d::Identity()));
  });
}

TEST(Units_of_results, of_maps_of_disks_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    r.add("circular_border", 0, IT::circular_border(x.t).positions);
    r.add("polygonal_border", 0, IT::polygonal_border(x.t, {{0, 0}, {1, 0}, {0, 1}}).positions);
    r.add("harmonic_map", 0, IT::harmonic_map(x.t));
    r.add("conformal_energy", 0, IT::conformal_energy(x.t));
    const Eigen::MatrixX2d uv = IT::least_squares_conformal_map(x.t);
    r.add("least_squares_conformal_map", 1, uv);
    r.add("spectral_conformal_map", 1, IT::spectral_conformal_map(x.t), 1e-9); // by iterations
    const IT::Map_distortion d = IT::measure_distortion(x.t, uv);
    r.add("measure_distortion", 0, std::array{d.mean_angle_change, d.minimum_area_ratio});
    T refined(x.t), mapped(x.t);
    r.add("injective_harmonic_map", 0, IT::injective_harmonic_map(refined).uv);
    r.add("parametrize", 1, IT::parametrize(mapped, IT::Map_method::least_squares).uv);
    r.add("map_to_plane", 1, IT::map_to_plane(mapped, {}, {IT::Map_method::least_squares}).uv);
    r.add("conformal_map_of_points", 1, IT::conformal_map_of_points(x.shape.points, 12), 1e-9);
    r.add("flat_surface", 1, IT::flat_surface(x.t.input()).length);
  });
}

TEST(Units_of_results, of_vectors_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    const IT::Tangent_field guide = IT::principal_directions(x.t, x.shape.points);
    r.add("principal_directions", -1, guide);
    r.add("aligned_direction_field", 0, IT::aligned_direction_field(x.t, 4, guide).powers);
    r.add("smoothest_direction_field", 0, IT::smoothest_direction_field(x.t, 2).powers);
    IT::Tangent_field field(x.shape.points.size());
    for (std::size_t i = 0; i < field.size(); ++i)
      field[i] = std::polar(x.unit, 0.3 * static_cast<double>(i));
    r.add("tangent_field_to_input", 1, IT::tangent_field_to_input(x.t, field));
    r.add("tangent_field_to_intrinsic", 1, IT::tangent_field_to_intrinsic(x.t, field));
    const IT::Tangent_vector v = IT::tangent_vector(x.t, x.vertex(24), field[24]);
    r.add("tangent_vector", 1, std::array{v.vector.x, v.vector.y});
    const IT::Vector_heat_method heat(x.t);
    r.add("voronoi_centres", 1,
          std::array{IT::voronoi_centres(heat, {x.point(2, .2, .3), x.point(60, .5, .1)},
                                         IT::parameters::maximum_rounds(3))
                         .largest_move});
    const IT::Place place = IT::Place::in_face(20, {.2, .3, .5});
    r.add("logarithms_from_place", 1,
          IT::logarithms_from_place(x.t, place, IT::Logarithm_method::affine, [&](const auto& p) {
            return heat.logarithmic_map(p, IT::Logarithm_method::affine);
          }));
    const IT::Point_cloud_vectors cloud(x.shape.points, 12);
    r.add("Point_cloud_vectors, transport", 1, cloud.transport({{24, Complex(x.unit, 0)}}));
    r.add("Point_cloud_vectors, logarithms", 1, cloud.logarithmic_map(24));
  });
}

TEST(Units_of_results, of_conformal_maps_are_the_users) {
  expect_powers(hills(), [](Sized& x, Results& r) {
    const IT::Uniformization plane = IT::uniformize(x.t);
    r.add("uniformize, factors", 0, plane.u);
    r.add("lay_out_scaled", 1, plane.layout.value().layout.positions);
  });
  expect_powers(grid(4), [](Sized& x, Results& r) {
    r.add("lay_out_in_plane", 1, IT::lay_out_in_plane(IT::flat_surface(x.t.input())).positions);
  });
  expect_powers(rough_torus(8, .2, 1), [](Sized& x, Results& r) {
    const IT::Uniformization torus = IT::uniformize(x.t);
    r.add("conformal_metric", 0, torus.metric.u);
    r.add("flat_torus", 0, std::array{torus.period.value()});
    // In the basis of its translations.
    r.add("lay_out_subdivision", 0, torus.layout.value().layout.positions);
  });
  // The unit sphere has a unit of its own.
  expect_powers(tetrahedron(), [](Sized& x, Results& r) {
    const IT::Uniformization sphere = IT::uniformize(x.t);
    r.add("conformal_sphere", 0, sphere.sphere.value().layout.positions);
    std::vector<double> u = sphere.u;
    for (double& y : u) y += std::log(x.unit);
    r.add("logarithmic_scale", 0, u, 1e-12);
  });
}

} // namespace
