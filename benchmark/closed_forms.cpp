// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How far are distances, logarithms, parallel transport and eigenvalues from closed forms, on bad
// triangles, their Delaunay triangulation and refinements of that?
//
// closed_forms > closed_forms.json; closed_forms_table.py makes tables of it
//
// Meshes are surfaces of revolution, of 48 rings of 100 vertices, with random edge splits until
// there are 40,000 faces: they change triangles, not the surface. A source, bearings and lengths of
// geodesics from there, and what a vector does along them, are those of the smooth surface, and are
// compared at the vertices of the rings.

#include "benchmark_support.h"
#include "synthetic_meshes.h"

#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Complex = std::complex<double>;
using Vector = Eigen::Vector3d;
constexpr double pi = std::numbers::pi;
constexpr Complex imaginary{0, 1};
constexpr std::uint32_t rings = 48, around = 100, source_ring = 23;
constexpr std::uint32_t source = around * source_ring;

/// A place on a surface of revolution: how far along the meridian, down from the first pole, and
/// the longitude.
struct Place {
  double s, longitude;
};

/// A shortest geodesic from the source. Bearings are counterclockwise from the east, where the
/// north is up the meridian.
struct Geodesic {
  double length, bearing_there, bearing_here;
};

struct Shape {
  std::string name;
  std::function<std::array<double, 2>(double)> profile; ///< radius and height
  double first, step;                                   ///< where the rings are along the meridian
  bool has_first_pole, has_last_pole, is_closed;
  /// Empty where there are no closed forms.
  std::function<Geodesic(Place, Place)> geodesic;
  std::function<bool(Place, Place)> is_clear; ///< whether the place is not near the cut locus
  std::vector<double> eigenvalues;            ///< without the zero, in ascending order
};

// ---- closed forms

// Of a cone of this total angle, unfolded; a disk is one of a full turn.
Geodesic on_cone(Place a, Place b, double angle) {
  const double part = angle / (2 * pi);
  const double turn = part * std::remainder(b.longitude - a.longitude, 2 * pi);
  const Complex way = b.s * std::polar(1.0, turn) - a.s;
  return {std::abs(way), std::arg(way / imaginary),
          std::arg(way / (imaginary * std::polar(1.0, turn)))};
}

Geodesic on_cylinder(Place a, Place b) {
  const Complex way(std::remainder(b.longitude - a.longitude, 2 * pi), a.s - b.s);
  return {std::abs(way), std::arg(way), std::arg(way)};
}

Geodesic on_sphere(Place a, Place b) {
  const double turn = b.longitude - a.longitude;
  // the north component of the way from x to y
  const auto north = [&](Place x, Place y) {
    return std::cos(y.s) * std::sin(x.s) - std::sin(y.s) * std::cos(x.s) * std::cos(turn);
  };
  const double east = std::sin(turn);
  const Complex there(std::sin(b.s) * east, north(a, b)), here(std::sin(a.s) * east, -north(b, a));
  const double cosine =
      std::cos(a.s) * std::cos(b.s) + std::sin(a.s) * std::sin(b.s) * std::cos(turn);
  return {std::atan2(std::abs(there), cosine), std::arg(there), std::arg(here)};
}

bool is_far_from_opposite_meridian(Place a, Place b) {
  return std::abs(std::remainder(b.longitude - a.longitude, 2 * pi)) < 0.8 * pi;
}

// ---- shapes

Shape sphere() {
  return {"sphere",
          [](double s) {
            return std::array{std::sin(s), std::cos(s)};
          },
          pi / (rings + 1),
          pi / (rings + 1),
          true,
          true,
          false,
          on_sphere,
          [](Place a, Place b) { return on_sphere(a, b).length < pi / 2; },
          {2, 2, 2, 6, 6, 6, 6, 6}};
}

// Of this total angle and slant height 1; eigenvalues are squares of zeros of derivatives of Bessel
// functions.
Shape cone(const std::string& name, double angle, std::vector<double> zeros) {
  for (double& z : zeros) z *= z;
  const double radius = angle / (2 * pi), height = std::sqrt(1 - radius * radius);
  return {name,
          [radius, height](double s) {
            return std::array{radius * s, -height * s};
          },
          1.0 / rings,
          1.0 / rings,
          true,
          false,
          false,
          [angle](Place a, Place b) { return on_cone(a, b, angle); },
          is_far_from_opposite_meridian,
          zeros};
}

Shape cylinder() {
  return {"cylinder",
          [](double s) {
            return std::array{1.0, -s};
          },
          0,
          3.0 / (rings - 1),
          false,
          false,
          false,
          on_cylinder,
          is_far_from_opposite_meridian,
          // squares of (k, pi l / 3)
          {1, 1, pi * pi / 9, 1 + pi * pi / 9, 1 + pi * pi / 9, 4, 4, 4 * pi * pi / 9}};
}

// With circles of radius 1 and 0.4. Eigenvalues are of the differential equation along the
// meridian, solved by 127 Fourier modes.
Shape torus() {
  return {"torus",
          [](double s) {
            return std::array{1 + 0.4 * std::cos(s / 0.4), -0.4 * std::sin(s / 0.4)};
          },
          0,
          0.8 * pi / rings,
          false,
          false,
          true,
          {},
          {},
          {1.02895616, 1.02895616, 3.61137760, 3.61137760, 6.16080019, 6.71014871, 7.20014061,
           7.20014061}};
}

// Every other ring is turned by half an edge.
Place place(const Shape& shape, std::uint32_t i) {
  const std::uint32_t r = i / around;
  return {shape.first + shape.step * r, 2 * pi * (i % around + (r % 2 == 0 ? 0 : 0.5)) / around};
}

IT::synthetic::Triangle_soup make_rings(const Shape& shape) {
  IT::synthetic::Triangle_soup soup;
  const auto add = [&](Place p) {
    const auto [radius, height] = shape.profile(p.s);
    soup.points.push_back({radius * std::cos(p.longitude), radius * std::sin(p.longitude), height});
    return static_cast<std::uint32_t>(soup.points.size() - 1);
  };
  const auto at = [](std::uint32_t r, std::uint32_t i) {
    return around * (r % rings) + i % around;
  };
  for (std::uint32_t i = 0; i < rings * around; ++i) add(place(shape, i));
  for (std::uint32_t r = 0; r + (shape.is_closed ? 0 : 1) < rings; ++r)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t apex =
          i + r % 2; // the next ring is turned by half an edge, there or back
      soup.triangles.push_back({at(r, i), at(r + 1, apex), at(r, i + 1)});
      soup.triangles.push_back({at(r + 1, i), at(r + 1, i + 1), at(r, i + (r + 1) % 2)});
    }
  if (shape.has_first_pole) {
    const std::uint32_t pole = add({shape.first - shape.step, 0});
    for (std::uint32_t i = 0; i < around; ++i)
      soup.triangles.push_back({pole, at(0, i), at(0, i + 1)});
  }
  if (shape.has_last_pole) {
    const std::uint32_t pole = add({shape.first + shape.step * rings, 0});
    for (std::uint32_t i = 0; i < around; ++i)
      soup.triangles.push_back({pole, at(rings - 1, i + 1), at(rings - 1, i)});
  }
  return soup;
}

Surface_mesh make_mesh(const Shape& shape) {
  return IT::synthetic::to_surface_mesh<Kernel::Point_3>(
      IT::synthetic::random_edge_splits(make_rings(shape), 40000));
}

// ---- errors

double mean(const std::vector<double>& errors) {
  double sum = 0;
  for (const double e : errors) sum += e;
  return sum / static_cast<double>(errors.size());
}

/// Of distances, by the greatest one: from the source, or on a torus from its outer equator.
double distance_error(const Shape& shape, const Triangulation& t, const Surface_mesh& mesh,
                      double time) {
  std::vector<Triangulation::vertex_descriptor> sources;
  for (std::uint32_t i = 0; i < around; ++i)
    if (!shape.geodesic || i == 0)
      sources.push_back(IT::vertex_on_intrinsic(
          t, Surface_mesh::Vertex_index(shape.geodesic ? source : i), mesh));
  const Eigen::VectorXd d =
      IT::Heat_distance(t, IT::parameters::time_factor(time)).distances(sources);
  std::vector<double> errors;
  double farthest = 0;
  for (std::uint32_t i = 0; i < rings * around; ++i) {
    const Place p = place(shape, i);
    const double exact = shape.geodesic ? shape.geodesic(place(shape, source), p).length
                                        : std::min(p.s, 0.8 * pi - p.s);
    errors.push_back(std::abs(d[i] - exact));
    farthest = std::max(farthest, exact);
  }
  return mean(errors) / farthest;
}

/// Calls a function with the number and the geodesic of each vertex that has one with a direction,
/// away from the cut locus, and inside: at the border vectors cannot point out of the surface.
template <class Function>
void for_each_clear(const Shape& shape, Function function) {
  const Place x = place(shape, source);
  for (std::uint32_t i = around; i < (rings - 1) * around; ++i)
    if (i != source && shape.is_clear(x, place(shape, i)))
      function(i, shape.geodesic(x, place(shape, i)));
}

/// Of logarithms, by the greatest one; turned to fit best, as the first direction at the source is
/// the triangulation's own.
double logarithm_error(const Shape& shape, const std::vector<Complex>& logarithms) {
  Complex turn = 0;
  double farthest = 0;
  for_each_clear(shape, [&](std::uint32_t i, const Geodesic& g) {
    turn += std::polar(g.length, g.bearing_there) * std::conj(logarithms[i]);
    farthest = std::max(farthest, g.length);
  });
  turn /= std::abs(turn);
  std::vector<double> errors;
  for_each_clear(shape, [&](std::uint32_t i, const Geodesic& g) {
    errors.push_back(std::abs(turn * logarithms[i] - std::polar(g.length, g.bearing_there)));
  });
  return mean(errors) / farthest;
}

/// A vector in space in the coordinates of the smooth surface.
Complex components(const Shape& shape, std::uint32_t i, const Vector& x) {
  const Place p = place(shape, i);
  constexpr double h = 1e-6;
  const auto after = shape.profile(p.s + h), before = shape.profile(p.s - h);
  const double c = std::cos(p.longitude), s = std::sin(p.longitude);
  const double out = (after[0] - before[0]) / (2 * h), up = (after[1] - before[1]) / (2 * h);
  return {x.dot(Vector(-s, c, 0)), -x.dot(Vector(out * c, out * s, up))};
}

/// Of directions, in radians.
double transport_error(const Shape& shape, const Triangulation& t, const Surface_mesh& mesh,
                       const IT::Tangent_field& field) {
  const auto vectors = IT::vectors_in_space(t, field, mesh);
  const auto direction = [&](std::uint32_t i) {
    return components(shape, i, Vector(vectors[i].data()));
  };
  const Complex start = direction(source);
  std::vector<double> errors;
  for_each_clear(shape, [&](std::uint32_t i, const Geodesic& g) {
    const Complex expected = start * std::polar(1.0, g.bearing_here - g.bearing_there);
    errors.push_back(std::abs(std::arg(direction(i) / expected)));
  });
  return mean(errors);
}

/// The greatest of eigenvalues, relative.
double eigenvalue_error(const Shape& shape, const Triangulation& t) {
  const auto n = static_cast<int>(shape.eigenvalues.size());
  const Eigen::VectorXd found =
      IT::smallest_eigenpairs(IT::cotangent_laplacian(t), IT::lumped_mass_matrix(t), n + 1).values;
  double greatest = 0;
  for (int i = 0; i < n; ++i)
    greatest = std::max(
        greatest, std::abs(found[i + 1] / shape.eigenvalues[static_cast<std::size_t>(i)] - 1));
  return greatest;
}

nlohmann::json errors(const Shape& shape, const Triangulation& t, const Surface_mesh& mesh,
                      double time = 1) {
  nlohmann::json result{{"vertices", t.number_of_vertices()},
                        {"distance", distance_error(shape, t, mesh, time)},
                        {"eigenvalues", eigenvalue_error(shape, t)}};
  if (!shape.geodesic) return result;
  const IT::Vector_heat_method<Triangulation> heat(t, IT::parameters::time_factor(time));
  const auto v = IT::vertex_on_intrinsic(t, Surface_mesh::Vertex_index(source), mesh);
  result["transport"] = transport_error(shape, t, mesh, heat.transport(v, 1));
  result["exact_logarithm"] = logarithm_error(shape, IT::logarithmic_map(t, v));
  result["affine_logarithm"] =
      logarithm_error(shape, heat.logarithmic_map(v, IT::Logarithm_method::affine));
  result["polar_logarithm"] =
      logarithm_error(shape, heat.logarithmic_map(v, IT::Logarithm_method::polar));
  return result;
}

nlohmann::json measure(const Shape& shape) {
  const Surface_mesh mesh = make_mesh(shape);
  Triangulation t(mesh);
  nlohmann::json result{{"as_is", errors(shape, t, mesh)}};
  IT::flip_to_delaunay(t);
  result["delaunay"] = errors(shape, t, mesh);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30));
  result["refined"] = errors(shape, t, mesh);
  result["longer"] = errors(shape, t, mesh, 16);
  return result;
}

} // namespace

int main() {
  try {
    nlohmann::json result;
    // zeros of derivatives of J_0, J_1, ...; of J_0, J_2, J_4, ... where the angle is half a turn
    const std::vector<double> disk_zeros{1.8411837813, 1.8411837813, 3.0542369282, 3.0542369282,
                                         3.8317059702, 4.2011889412, 4.2011889412, 5.3175531261};
    const std::vector<double> cone_zeros{3.0542369282, 3.0542369282, 3.8317059702, 5.3175531261,
                                         5.3175531261, 6.7061331942, 6.7061331942, 7.0155866698};
    for (const Shape& shape : {cone("disk", 2 * pi, disk_zeros), cone("cone", pi, cone_zeros),
                               cylinder(), sphere(), torus()}) {
      result[shape.name] = measure(shape);
      std::cerr << shape.name << ' ' << result[shape.name].dump() << '\n';
    }
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "closed_forms: " << e.what() << '\n';
    return 1;
  }
}
