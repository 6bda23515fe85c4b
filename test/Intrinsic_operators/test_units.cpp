// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Lengths, areas and vectors are in the units of the input. Oracles: Euclid in a plane and on the
// unfolded cube, at scales that the library takes to units of its own, powers of two and others.

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_operators.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Point = Mesh::Point;
using Triangulation = IT::Corresponding_triangulation;
using Complex = std::complex<double>;
using IT::Surface_point;

constexpr double scales[] = {0x1p-40, 1, 1e3, 1e-3 * 0x1p20};
constexpr std::size_t cells = 6; // the side of the square, in units of the scale

Complex plane(const Point& p) { return {p.x(), p.y()}; }

// A square in the plane. Vertices inside are moved at random, so that no point is special and flips
// change the triangulation.
struct Square {
  Square(double s, unsigned seed) : scale(s), random(seed) {
    std::vector<Mesh::Vertex_index> v;
    for (std::size_t j = 0; j <= cells; ++j)
      for (std::size_t i = 0; i <= cells; ++i) {
        const bool moves = i % cells != 0 && j % cells != 0;
        v.push_back(
            mesh.add_vertex(Point(s * (static_cast<double>(i) + (moves ? shift() : 0)),
                                  s * (static_cast<double>(j) + (moves ? shift() : 0)), 0)));
      }
    for (std::size_t j = 0; j < cells; ++j)
      for (std::size_t i = 0; i < cells; ++i) {
        const std::size_t k = i + (cells + 1) * j, above = k + cells + 1;
        mesh.add_face(v[k], v[k + 1], v[above + 1]);
        mesh.add_face(v[k], v[above + 1], v[above]);
      }
  }

  double uniform() { return (static_cast<double>(random()) + 0.5) / 0x1p32; }
  double shift() { return 0.6 * uniform() - 0.3; }
  // in a face of the input
  Surface_point point(const Triangulation& t) {
    const double a = uniform(), b = (1 - a) * uniform();
    return {t.input().halfedge_of_face(
                static_cast<std::uint32_t>(random() % t.input().number_of_faces())),
            {1 - a - b, a, b}};
  }
  Complex at(const Triangulation& t, const Surface_point& on_input) const {
    return plane(IT::point_in_space(t, on_input, mesh));
  }
  // a vector in the frame of a face of the input, as one of the plane
  Complex in_plane(const Triangulation& t, const IT::Tangent_vector& v) const {
    const std::uint32_t h = v.point.halfedge;
    const Complex side = at(t, {h, {0, 1, 0}}) - at(t, {h, {1, 0, 0}});
    return Complex(v.vector[0], v.vector[1]) * side / std::abs(side);
  }
  Complex at(const Triangulation& t, Triangulation::vertex_descriptor v) const {
    return plane(mesh.point(Mesh::Vertex_index(t.input_vertex(v))));
  }

  double scale;
  std::mt19937 random;
  Mesh mesh;
};

void expect_near(double a, double b, double tolerance) {
  EXPECT_NEAR(a / b, 1, tolerance) << a << " for " << b;
}

template <class Test>
void on_squares(const Test& test) {
  unsigned seed = 0;
  for (const double scale : scales) {
    SCOPED_TRACE(scale);
    Square s(scale, ++seed);
    Triangulation t(s.mesh);
    IT::flip_to_delaunay(t);
    test(s, t);
  }
}

TEST(Units, of_vectors_that_are_taken_to_the_other_triangulation_are_those_of_the_input) {
  on_squares([](Square& s, const Triangulation& t) {
    for (int i = 0; i < 20; ++i) {
      Surface_point p = s.point(t);
      if (i % 3 == 1) p.weights = {1 - p.weights[1], p.weights[1], 0};
      const IT::Tangent_vector v{p, {s.scale * s.shift(), s.scale * s.shift()}};
      const IT::Tangent_vector there = IT::tangent_to_intrinsic(t, v).value(),
                               back = IT::tangent_to_input(t, there).value();
      const double length = std::hypot(v.vector[0], v.vector[1]);
      expect_near(std::hypot(there.vector[0], there.vector[1]), length, 1e-12);
      EXPECT_LE(std::abs(s.in_plane(t, back) - s.in_plane(t, v)), 1e-9 * length);
    }
  });
}

TEST(Units, of_traced_geodesics_are_those_of_the_input) {
  on_squares([](Square& s, const Triangulation& t) {
    for (int i = 0; i < 20; ++i) {
      const Surface_point p = s.point(t);
      const IT::Tangent_vector v{p, {s.shift(), s.shift()}}; // any norm
      const double length = 0.5 * s.scale * s.uniform();
      const IT::Tangent_vector there = IT::tangent_to_intrinsic(t, v).value();
      const IT::Geodesic g = IT::trace_geodesic_on_input(t, p, v.vector, length),
                         h = IT::trace_geodesic(t, there.point, there.vector, length);
      if (g.status != IT::Status::done) continue; // over the border
      const Complex end = s.at(t, p) + length * s.in_plane(t, v) / std::abs(s.in_plane(t, v));
      EXPECT_LE(std::abs(s.at(t, g.points.back()) - end), 1e-9 * s.scale);
      EXPECT_LE(std::abs(s.at(t, *IT::locate_on_input(t, h.points.back())) - end), 1e-9 * s.scale);
      EXPECT_EQ(g.length, length);
      EXPECT_LE(g.error, 1e-9 * s.scale);
      double sum = 0;
      for (std::size_t k = 0; k + 1 < g.points.size(); ++k) {
        const auto ends = IT::points_in_one_face(t.input(), g.points[k], g.points[k + 1]).value();
        const IT::Unscaled_vector x = IT::vector_between(t.input(), ends.first, ends.second);
        sum += std::hypot(x[0], x[1]);
      }
      expect_near(sum, length, 1e-9);
    }
  });
}

TEST(Units, of_exact_distances_and_logarithms_are_those_of_the_input) {
  on_squares([](Square& s, const Triangulation& t) {
    const auto source = IT::vertex_of_row(t, static_cast<std::uint32_t>(2 * (cells + 1) + 2));
    const IT::Polyhedral_distance distance(t, source);
    const std::vector<Complex> log = IT::logarithmic_map(t, source);
    for (const auto v : vertices(t.mesh())) {
      if (v == source) continue;
      const double wanted = std::abs(s.at(t, v) - s.at(t, source));
      expect_near(distance.distance(v), wanted, 1e-12);
      const IT::Tangent_vector x = distance.logarithm(v);
      expect_near(std::hypot(x.vector[0], x.vector[1]), wanted, 1e-12);
      expect_near(std::abs(log[t.index(v)]), wanted, 1e-12);
      const IT::Geodesic g = IT::exponential_map(t, source, log[t.index(v)]);
      EXPECT_LE(std::abs(s.at(t, *IT::locate_on_input(t, g.points.back())) - s.at(t, v)),
                1e-9 * s.scale);
      const IT::Traced_curve way = IT::trace_shortest_path(t, distance.shortest_path(v));
      expect_near(way.length, wanted, 1e-12);
      EXPECT_EQ(way.status, IT::Status::done);
      EXPECT_EQ(s.at(t, way.points.back()), s.at(t, v));
    }
    const IT::Polyhedral_distance near(t, source, IT::parameters::maximum_distance(2 * s.scale));
    for (const auto v : vertices(t.mesh()))
      if (std::abs(s.at(t, v) - s.at(t, source)) > 2 * s.scale)
        EXPECT_TRUE(std::isinf(near.distance(v)));
      else
        EXPECT_EQ(near.distance(v), distance.distance(v));
  });
}

TEST(Units, of_isolines_and_cells_are_those_of_the_input) {
  on_squares([](Square& s, const Triangulation& t) {
    std::vector<double> x;
    for (const auto v : vertices(s.mesh)) x.push_back(s.mesh.point(v).x());
    const std::array<double, 1> level{2.5 * s.scale};
    const auto lines = IT::isolines(t, x, level);
    ASSERT_EQ(lines.size(), 1U);
    expect_near(IT::length_of_isoline(t, lines[0]), cells * s.scale, 1e-12);
    expect_near(IT::trace_isoline(t, lines[0]).length, cells * s.scale, 1e-12);

    const std::uint32_t corner = cells, above = (cells + 1) * cells + cells;
    const std::vector sources{IT::vertex_of_row(t, corner), IT::vertex_of_row(t, above)};
    const IT::Polyhedral_distance distance(t, sources);
    const IT::Voronoi_cells found = IT::voronoi_cells(distance);
    for (const double area : found.areas) expect_near(area, 18 * s.scale * s.scale, 1e-6);
    ASSERT_EQ(found.boundaries.size(), 1U);
    const IT::Traced_curve line = IT::trace_boundary(t, found.boundaries[0]);
    expect_near(line.length, cells * s.scale, 1e-6);
    EXPECT_NE(line.status, IT::Status::not_traceable);
  });
}

TEST(Units, of_curves_that_become_edges_are_those_of_the_input) {
  on_squares([](Square& s, Triangulation& t) {
    const auto v = [&](std::uint32_t row) { return IT::vertex_of_row(t, row); };
    const double wanted = std::abs(s.at(t, v(9)) - s.at(t, v(38)));
    IT::Curve_network network(t);
    IT::add_geodesics(network, std::vector{IT::Curve_through_vertices<Triangulation>{
                                   {v(9), v(38)}, false, true}});
    expect_near(network.length(), wanted, 1e-12);
    network.clear();

    const std::vector<Surface_point> points =
        IT::trace_geodesic_on_input(t, s.point(t), {0.6, 0.8}, s.scale).points;
    const auto path = IT::insert_polyline(t, points);
    ASSERT_EQ(path.status, IT::Move_status::done);
    double length = 0;
    for (const auto h : path.halfedges) length += t.length(edge(h, t.mesh()));
    expect_near(length, std::abs(s.at(t, points.back()) - s.at(t, points.front())), 1e-9);

    const auto tree = IT::flip_to_geodesic_tree(t, v(9));
    expect_near(tree.length(v(38)), wanted, 1e-12);
    expect_near(IT::total_area(t), cells * cells * s.scale * s.scale, 1e-12);
  });
}

TEST(Units, of_transported_vectors_are_those_of_the_input) {
  on_squares([](Square& s, const Triangulation& t) {
    const IT::Vector_heat_method heat(t);
    const IT::Tangent_vector v{s.point(t), {s.scale, -2 * s.scale}};
    const IT::Tangent_vector there = IT::tangent_to_intrinsic(t, v).value();
    const IT::Tangent_field field = heat.transport(there);
    const auto in_space = IT::vectors_in_space(t, field, s.mesh);
    const Complex wanted = s.in_plane(t, v);
    for (const auto& x : in_space)
      EXPECT_LE(std::abs(Complex(x[0], x[1]) - wanted), 1e-6 * std::abs(wanted));
    const auto log = heat.logarithmic_map(there.point, IT::Logarithm_method::affine);
    const double turn = std::arg(wanted) - std::arg(Complex(there.vector[0], there.vector[1]));
    for (const auto w : vertices(t.mesh()))
      EXPECT_LE(std::abs(log[t.index(w)] * std::polar(1., turn) - (s.at(t, w) - s.at(t, v.point))),
                1e-6 * s.scale);
    const auto a = IT::locate_on_intrinsic(t, s.point(t)).value();
    const auto b = IT::locate_on_intrinsic(t, s.point(t)).value();
    const auto mean = IT::karcher_mean(heat, {{a, 1}, {b, 1}});
    const double apart =
        std::abs(s.at(t, *IT::locate_on_input(t, a)) - s.at(t, *IT::locate_on_input(t, b)));
    expect_near(mean.energy, apart * apart / 4, 1e-4);
  });
}

TEST(Units, of_matrices_and_gradients_are_those_of_the_input) {
  on_squares([](Square& s, const Triangulation& t) {
    const double unit = s.scale, area = cells * cells * unit * unit;
    Eigen::VectorXd x(static_cast<Eigen::Index>(t.number_of_vertices()));
    for (const auto v : vertices(s.mesh)) x[static_cast<Eigen::Index>(v)] = s.mesh.point(v).x();
    expect_near(x.dot(IT::cotangent_laplacian(t) * x), area, 1e-10);
    expect_near(IT::galerkin_mass_matrix(t).sum(), area, 1e-12);
    expect_near(IT::lumped_mass_matrix(t).diagonal().sum(), area, 1e-12);
    expect_near(IT::quadratic_mass_matrix(t).sum(), area, 1e-12);
    expect_near(IT::hodge_star_0(t).sum(), area, 1e-12);
    double sum = 0;
    const Eigen::VectorXd star = IT::hodge_star_2(t);
    const IT::Face_gradient gradient(t);
    for (const auto f : faces(t.mesh())) {
      sum += t.area(f);
      expect_near(star[t.index(f)] * t.area(f), 1, 1e-12);
      expect_near(gradient.area(t.index(f)), t.area(f), 1e-12);
    }
    expect_near(sum, area, 1e-12);
    const Eigen::VectorXcd g = gradient.gradient(x);
    for (const auto f : faces(t.mesh())) expect_near(std::abs(g[t.index(f)]), 1, 1e-9);
    const Eigen::VectorXd far = IT::Heat_distance(t).distances(IT::vertex_of_row(t, 0));
    expect_near(far.maxCoeff(), unit * cells * std::numbers::sqrt2, 0.2);
  });
}

// Across two sides of a cube from a corner to the opposite one.
TEST(Units, on_a_cube_are_those_of_the_input) {
  for (const double scale : scales) {
    SCOPED_TRACE(scale);
    Mesh mesh;
    std::vector<Mesh::Vertex_index> v;
    for (int i = 0; i < 8; ++i)
      v.push_back(mesh.add_vertex(Point(scale * (i & 1), scale * (i >> 1 & 1), scale * (i >> 2))));
    for (const auto& q : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                          std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
      const auto at = [&](std::size_t k) { return v[static_cast<std::size_t>(q[k])]; };
      mesh.add_face(at(0), at(1), at(2));
      mesh.add_face(at(0), at(2), at(3));
    }
    Triangulation t(mesh);
    const double wanted = std::sqrt(5) * scale;
    const auto from = IT::vertex_of_row(t, 0), to = IT::vertex_of_row(t, 7);
    const IT::Polyhedral_distance distance(t, from);
    expect_near(distance.distance(to), wanted, 1e-14);
    const IT::Tangent_vector x = distance.logarithm(to);
    expect_near(std::hypot(x.vector[0], x.vector[1]), wanted, 1e-14);
    expect_near(IT::trace_shortest_path(t, distance.shortest_path(to)).length, wanted, 1e-14);
    expect_near(IT::total_area(t), 6 * scale * scale, 1e-14);
    IT::Curve_network network(t);
    IT::add_geodesics(
        network, std::vector{IT::Curve_through_vertices<Triangulation>{{from, to}, false, true}});
    expect_near(network.length(), wanted, 1e-14);
    expect_near(IT::trace_curve(t, network.halfedges(0)).length, wanted, 1e-14);
  }
}

TEST(units, areas_of_improved_surfaces) {
  for (const double scale : scales) {
    const Square q(scale, 5);
    Triangulation t(q.mesh);
    std::vector<std::array<double, 3>> points;
    for (const Mesh::Vertex_index v : q.mesh.vertices()) {
      const Point& p = q.mesh.point(v);
      points.push_back({p.x(), p.y(), p.z()});
    }
    const auto kept = IT::labelled_input_edges(t, {});
    IT::Improved_surface result = IT::improve_soundly(t, points, {}, kept);
    EXPECT_NO_THROW(IT::expect_area_kept(t, false, result));
    IT::measure_improved(t, points, kept, false, result);
    const double area = cells * cells * scale * scale;
    EXPECT_NEAR(result.input_area / area, 1, 1e-12);
    EXPECT_NEAR(result.measured.area / area, 1, 1e-12);
    IT::Distances<Triangulation> find(t);
    const IT::Found_cells halves =
        IT::divide_among(find, {{IT::Place::at_vertex(0)}, {IT::Place::at_vertex(cells)}});
    for (const double half : halves.cells.areas) EXPECT_NEAR(half / area, 0.5, 1e-9);
  }
}

} // namespace
