// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does it take to find all symmetries of a surface, beside its exact Delaunay flips: on grid
// tori of revolution, on flat tori, and on files?
// Usage: isometry_speed [FILE...] > isometry_speed.json

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

class Watch {
public:
  double lap() {
    const auto before = std::exchange(last_, std::chrono::steady_clock::now());
    return std::chrono::duration<double>(last_ - before).count();
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// n times n trapezoids with lengths that depend on the row only: exactly symmetric
IT::Intrinsic_input torus_of_revolution(std::uint32_t n) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  const auto v = [n](std::uint32_t i, std::uint32_t j) { return j % n * n + i % n; };
  const auto width = [n](std::uint32_t j) { // has few digits, so that diagonals are exact
    const double w = (2 + std::cos(2 * std::numbers::pi * (j % n) / n)) / n;
    return std::round(w * 0x1p30) * 0x1p-30;
  };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      faces.push_back({v(i, j), v(i + 1, j), v(i + 1, j + 1)});
      faces.push_back({v(i, j), v(i + 1, j + 1), v(i, j + 1)});
    }
  IT::Gluing_map mesh(IT::gluing_from_triangles(n * n, faces));
  const double side = std::round(0x1p30 * 4 / n) * 0x1p-30;
  std::vector<double> lengths;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const IT::Gluing_map::Halfedge h{2 * e};
    const std::uint32_t p = mesh.source(h).index, q = mesh.target(h).index;
    const double a = width(p / n), b = width(q / n);
    // the diagonal of an isosceles trapezoid: side^2 + a b
    lengths.push_back(p / n == q / n ? a * a : p % n == q % n ? side * side : side * side + a * b);
  }
  return IT::Intrinsic_input(std::move(mesh), std::move(lengths));
}

// n times n squares, of which all vertices but one are removed
IT::Intrinsic_input flat_torus(std::uint32_t n) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  const auto v = [n](std::uint32_t i, std::uint32_t j) { return j % n * n + i % n; };
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      faces.push_back({v(i, j), v(i + 1, j), v(i + 1, j + 1)});
      faces.push_back({v(i, j), v(i + 1, j + 1), v(i, j + 1)});
    }
  IT::Gluing_map mesh(IT::gluing_from_triangles(n * n, faces));
  std::vector<double> lengths;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const IT::Gluing_map::Halfedge h{2 * e};
    const std::uint32_t p = mesh.source(h).index, q = mesh.target(h).index;
    lengths.push_back(p / n == q / n || p % n == q % n ? 1 : 2);
  }
  return IT::Intrinsic_input(std::move(mesh), std::move(lengths));
}

nlohmann::json measure(IT::Intrinsic_input input) {
  IT::Corresponding_triangulation t(std::move(input));
  Watch watch;
  const auto flipped = IT::flip_to_delaunay(t);
  nlohmann::json result = {{"faces", t.mesh().number_of_faces()},
                           {"flips", flipped.flips},
                           {"seconds_of_flips", watch.lap()}};
  const IT::Canonical_form form = IT::canonical_form(t);
  result["seconds_of_form"] = watch.lap();
  result["flat_vertices"] = form.number_of_flat_vertices();
  const IT::Isometries found = IT::find_isometries(form, form);
  result["seconds_of_isometries"] = watch.lap();
  (void)form.hash();
  result["seconds_of_hash"] = watch.lap();
  result["answer"] = IT::name_of(found.answer());
  result["count"] = found.count();
  result["walks"] = found.number_of_walks();
  return result;
}

} // namespace

int main(int argc, char* argv[]) {
  nlohmann::json all;
  for (const std::uint32_t n : {71U, 224U, 707U})
    all["torus of revolution"].push_back(measure(torus_of_revolution(n)));
  for (const std::uint32_t n : {22U, 70U, 224U})
    all["flat torus"].push_back(measure(flat_torus(n)));
  for (int i = 1; i < argc; ++i) all[argv[i]] = measure(IT::read_surface(argv[i]).input);
  std::cout << all.dump(2) << '\n';
}
