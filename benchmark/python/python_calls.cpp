// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long do the calls take in C++ that methods in Python make? `python_calls.py` runs this
// program, and puts its times beside those of Python.

#include "benchmark_support.h"

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_operators.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;

// The least time of each call over all repetitions, in the order of the calls.
class Times {
public:
  template <class Function>
  auto operator()(const std::string& call, const Function& function) {
    const double begin = IT::benchmark::processor_time();
    auto result = function();
    const double time = IT::benchmark::processor_time() - begin;
    const auto place = json_.find(call);
    json_[call] = place == json_.end() ? time : std::min(time, place->get<double>());
    return result;
  }
  const nlohmann::ordered_json& json() const { return json_; }

private:
  nlohmann::ordered_json json_;
};

struct Mesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

IT::Given_vectors vector_at(std::uint32_t vertex) {
  return {{IT::Place::at_vertex(vertex)}, {{1, 0}}, {}};
}

void measure_distances(const Exact& d, Times& times) {
  const auto n = static_cast<std::uint32_t>(d.number_of_vertices());
  const auto at = [](std::uint32_t v) { return std::vector{IT::Place::at_vertex(v)}; };
  IT::Distance_options exact, heat;
  heat.method = IT::Distance_method::heat;
  IT::Distances<Exact> by_heat(d), shortest(d);
  times("distance by heat", [&] { return by_heat.from(at(0), heat); });
  times("again: distance by heat", [&] { return by_heat.from(at(n / 3), heat); });
  times("distance", [&] { return shortest.from(at(0), exact); });
  times("again: distance", [&] { return shortest.from(at(n / 3), exact); });
}

// Paths change the triangulation: the first one needs a copy, as in Python. Shortest paths are
// found on the Delaunay triangulation, those by flips begin along edges of the mesh.
void measure_curves(const Exact& t, const Exact& d, Times& times) {
  const auto n = static_cast<std::uint32_t>(d.number_of_vertices());
  for (const bool is_shortest : {true, false}) {
    const Exact& given = is_shortest ? d : t;
    const std::string name = is_shortest ? "path" : "path by flips";
    std::optional<Exact> copy;
    std::optional<IT::Geodesic_finder<Exact>> find;
    const auto path = [&](std::uint32_t from) {
      if (!find) find.emplace(copy.emplace(given));
      return (*find)(copy->numbers().vertex_at(from), copy->numbers().vertex_at(n / 2),
                     IT::parameters::shortest(is_shortest));
    };
    times(name, [&] { return path(0); });
    times("again: " + name, [&] { return path(n / 3); });
  }
}

void measure_vectors(const Exact& d, const Mesh& mesh, Times& times) {
  const auto n = static_cast<std::uint32_t>(d.number_of_vertices());
  IT::Vectors<Exact> vectors(d, mesh.points);
  const auto field = times("transport", [&] { return vectors.transport(vector_at(0)); });
  times("again: transport", [&] { return vectors.transport(vector_at(n / 3)); });
  times("vectors", [&] { return IT::Vertex_sectors(d, mesh.points).in_space(field.vectors); });
  const IT::Vertex_sectors sectors(d, mesh.points);
  times("again: vectors", [&] { return sectors.in_space(field.vectors); });
  for (const auto& [name, method] : {std::pair("exact", IT::Logarithm_method::exact),
                                     std::pair("affine", IT::Logarithm_method::affine),
                                     std::pair("polar", IT::Logarithm_method::polar)}) {
    IT::Vectors<Exact> own(d, mesh.points);
    const std::string call = std::string("log_map ") + name;
    times(call, [&] { return own.logarithms(IT::Place::at_vertex(0), method); });
    times("again: " + call, [&] { return own.logarithms(IT::Place::at_vertex(n / 3), method); });
  }
  times("direction_field", [&] { return vectors.directions(4); });
}

void measure(const Mesh& mesh, Times& times) {
  const IT::Surface_options options;
  const IT::Built_surface<Exact> built = times("Surface", [&] {
    return IT::build_surface<Exact>(
        IT::make_surface(IT::triangle_soup(mesh.points, mesh.faces, options.polygons), options));
  });
  const Exact& t = built.triangulation;
  // a surface never changes in Python: there is a copy in these
  const Exact d = times("delaunay", [&] {
    Exact copy = t;
    IT::flip_to_delaunay(copy);
    return copy;
  });
  times("refine", [&] {
    Exact copy = t;
    IT::flip_to_delaunay(copy);
    IT::delaunay_refine(copy, IT::parameters::minimum_angle(25));
    return copy;
  });
  times("laplacian", [&] { return IT::cotangent_laplacian(d); });
  times("mass", [&] { return IT::lumped_mass_matrix(d); });
  times("galerkin mass", [&] { return IT::galerkin_mass_matrix(d); });
  Exact measured = d;
  times("statistics", [&] {
    return IT::measure(measured, IT::Marked_edges<Exact, std::uint32_t>(measured), mesh.points);
  });
  measure_distances(d, times);
  measure_curves(t, d, times);
  measure_vectors(d, mesh, times);
}

} // namespace

int main(int argc, char** argv) try {
  if (argc < 2) throw std::runtime_error("usage: python_calls MESH [REPETITIONS]");
  const IT::Polygon_soup soup = IT::read_polygon_soup(argv[1]);
  const Mesh mesh{soup.points, soup.faces};
  Times times;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 5;
  for (int i = 0; i < repetitions; ++i) measure(mesh, times);
  std::cout << times.json().dump(2) << '\n';
  return 0;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
