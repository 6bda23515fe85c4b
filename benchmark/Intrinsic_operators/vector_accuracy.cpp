// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How accurate are parallel transport and logarithmic maps on bad triangles: on the mesh, the Delaunay triangulation, the refined one?
//
//   vector_accuracy > vectors.json
//
// The mesh is a unit sphere of 11 rings of 200 vertices and two poles, whose triangles are long and sheared. Errors are those at its vertices
// up to a quarter of a great circle from one on the equator: of directions in radians, and of distances. Transport is compared with the rotation
// from point to point, lengths of logarithms with angles.

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Vector = Eigen::Vector3d;

constexpr std::uint32_t rings = 11, around = 200;
constexpr std::uint32_t source = around * (rings / 2); // on the equator

Mesh sliver_sphere() {
  using Vertex = Mesh::Vertex_index;
  Mesh mesh;
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double a = std::numbers::pi * (r + 1) / (rings + 1),
                   b = 2 * std::numbers::pi * i / around + 0.3 * r; // sheared
      mesh.add_vertex({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  const Vertex north = mesh.add_vertex({0, 0, 1}), south = mesh.add_vertex({0, 0, -1});
  const auto at = [](std::uint32_t r, std::uint32_t i) { return Vertex(around * r + i % around); };
  for (std::uint32_t i = 0; i < around; ++i) {
    mesh.add_face(north, at(0, i), at(0, i + 1));
    mesh.add_face(south, at(rings - 1, i + 1), at(rings - 1, i));
    for (std::uint32_t r = 0; r + 1 < rings; ++r) {
      mesh.add_face(at(r, i), at(r + 1, i), at(r, i + 1));
      mesh.add_face(at(r, i + 1), at(r + 1, i), at(r + 1, i + 1));
    }
  }
  return mesh;
}

/// The angle in the tangent plane at `y` between a vector that came from `x` and the one that `e` becomes on the way.
double direction_error(const Vector& x, const Vector& e, const Vector& y, const Vector& there) {
  const Vector expected = e - e.dot(y) / (1 + x.dot(y)) * (x + y);
  return std::abs(std::atan2(expected.cross(there).dot(y),
                             expected.dot(there) - expected.dot(y) * there.dot(y)));
}

/// The greatest and the mean of errors.
struct Errors {
  double greatest = 0, sum = 0;
  std::size_t count = 0;

  void add(double e) {
    greatest = std::max(greatest, e);
    sum += e;
    ++count;
  }
  nlohmann::json json() const {
    return {{"greatest", greatest}, {"mean", sum / static_cast<double>(count)}};
  }
};

nlohmann::json measure(const std::string& name, const Triangulation& t, const Mesh& mesh) {
  const IT::Vector_heat_method<Triangulation> heat(t);
  const auto v = IT::vertex_on_intrinsic(t, Mesh::Vertex_index(source), mesh);
  const auto transported = IT::vectors_in_space(t, heat.transport(v, 1), mesh);
  const auto affine = heat.logarithmic_map(v, IT::Logarithm_method::affine),
             polar = heat.logarithmic_map(v, IT::Logarithm_method::polar),
             exact = heat.logarithmic_map(v);
  const auto place = [&](std::uint32_t i) {
    const auto& p = mesh.point(Mesh::Vertex_index(i));
    return Vector(p.x(), p.y(), p.z());
  };
  const auto vector = [&](std::uint32_t i) { return Vector(transported[i].data()); };
  const Vector x = place(source), e = vector(source);
  Errors directions, affine_lengths, polar_lengths, exact_lengths;
  for (std::uint32_t i = 0; i < mesh.number_of_vertices(); ++i) {
    const Vector y = place(i);
    if (i == source || x.dot(y) < 0) continue;
    directions.add(direction_error(x, e, y, vector(i)));
    const double r = std::atan2(x.cross(y).norm(), x.dot(y));
    affine_lengths.add(std::abs(std::abs(affine[i]) - r));
    polar_lengths.add(std::abs(std::abs(polar[i]) - r));
    exact_lengths.add(std::abs(std::abs(exact[i]) - r));
  }
  return {{"triangulation", name},
          {"vertices", t.number_of_vertices()},
          {"transport", directions.json()},
          {"exact_logarithm", exact_lengths.json()},
          {"affine_logarithm", affine_lengths.json()},
          {"polar_logarithm", polar_lengths.json()}};
}

} // namespace

int main() {
  const Mesh mesh = sliver_sphere();
  Triangulation t(mesh);
  nlohmann::json rows{measure("mesh", t, mesh)};
  IT::flip_to_delaunay(t);
  rows.push_back(measure("Delaunay", t, mesh));
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30));
  rows.push_back(measure("refined", t, mesh));
  std::cout << rows.dump(2) << '\n';
}
