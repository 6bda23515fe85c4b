// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does Delaunay refinement take, exactly (the default setting: with integer coordinates)
// and with doubles, compared with CGAL's intrinsic Delaunay triangulation of the heat method, on
// single meshes, on three CAD parts of slivers and needles, and on all meshes of the data set; and
// does its time grow linearly with the vertices inserted?
// Usage: refinement [DIRECTORY [REPETITIONS [MAXIMUM_INSERTIONS]]] > result.json

#include "benchmark_support.h"
#include "cad_parts.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

template <class Correspondence>
using Doubles =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>, Correspondence>;
template <class Correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;
using Lengths_only = Doubles<IT::No_correspondence>;

struct Refined {
  double milliseconds = 0;
  std::uint64_t inserted = 0;
  std::size_t unsatisfied = 0;
};

struct Criteria {
  double minimum_angle = 25;
  double maximum_circumradius = std::numeric_limits<double>::infinity();
  std::optional<std::uint64_t> maximum_insertions = std::nullopt;
};

// Building and refining, as the yardstick builds as well.
template <class Triangulation>
Refined run_refinement(const Surface_mesh& mesh, const Criteria& criteria) {
  const double start = processor_time();
  Triangulation t(mesh);
  const auto result =
      IT::delaunay_refine(t, IT::parameters::minimum_angle(criteria.minimum_angle)
                                 .maximum_circumradius(criteria.maximum_circumradius)
                                 .maximum_insertions(criteria.maximum_insertions));
  return {processor_time() - start, result.counts.inserted_vertices(), result.unsatisfied.size()};
}

struct Contender {
  std::string name;
  Refined (*run)(const Surface_mesh&, const Criteria&);
};
// each exact one after its double
const std::vector<Contender> contenders = {
    {"double_integer", run_refinement<Doubles<IT::Integer_coordinates>>},
    {"exact_integer", run_refinement<Exact<IT::Integer_coordinates>>},
    {"double", run_refinement<Lengths_only>},
    {"exact", run_refinement<Exact<IT::No_correspondence>>},
    {"double_crossings", run_refinement<Doubles<IT::Explicit_crossings>>},
    {"exact_crossings", run_refinement<Exact<IT::Explicit_crossings>>},
    {"double_signposts", run_refinement<Doubles<IT::Signposts>>},
    {"exact_signposts", run_refinement<Exact<IT::Signposts>>}};

struct Workload {
  std::string name;
  std::function<Surface_mesh()> make;
};

std::vector<Workload> workloads(const std::string& directory) {
  std::vector<Workload> result;
  for (const char* name : {"camel", "armadillo", "refined_elephant", "spool", "blade", "cheese"})
    result.push_back({name, [=] { return read_mesh(directory, name); }});
  result.push_back({"shear_torus", [] {
                      return IT::synthetic::to_surface_mesh<Kernel::Point_3>(
                          IT::synthetic::shear_torus());
                    }});
  const auto add_part = [&](const char* name, auto make) {
    result.push_back(
        {name, [=] { return IT::synthetic::to_surface_mesh<Kernel::Point_3>(make()); }});
  };
  add_part("rounded_plate", [] { return IT::synthetic::rounded_plate(5000); });
  add_part("stepped_shaft", [] { return IT::synthetic::stepped_shaft(1430); });
  add_part("plate_with_holes", [] { return IT::synthetic::plate_with_holes(6, 830); });
  result.push_back({"arma_split200k", [=] { return split_armadillo(directory, 200000); }});
  result.push_back({"arma_s2x6", [=] {
                      const auto soup = IT::synthetic::to_soup(read_mesh(directory, "armadillo"));
                      return IT::synthetic::to_surface_mesh<Kernel::Point_3>(
                          IT::synthetic::stretch_x(IT::synthetic::midpoint_subdivide(soup, 2), 6));
                    }});
  result.push_back({"arma_split1M", [=] { return split_armadillo(directory, 1000000); }});
  return result;
}

nlohmann::json row(const Refined& r, double fastest, double yardstick) {
  nlohmann::json result = {{"milliseconds", fastest},
                           {"ratio_to_cgal", fastest / yardstick},
                           {"inserted_vertices", r.inserted},
                           {"unsatisfied_faces", r.unsatisfied}};
  if (r.inserted > 0)
    result["microseconds_per_inserted_vertex"] = 1e3 * fastest / static_cast<double>(r.inserted);
  return result;
}

// Alternates the contenders, so that a slow spell of the machine hits all of them.
nlohmann::json measure(const Surface_mesh& mesh, std::size_t repetitions) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const std::vector<double> angles = {25, 30};
  double yardstick = never;
  std::vector<std::vector<double>> fastest(contenders.size(),
                                           std::vector<double>(angles.size(), never));
  nlohmann::json result = {{"faces", num_faces(mesh)}};
  for (std::size_t i = 0; i < repetitions; ++i) {
    const double start = processor_time();
    run_cgal(mesh);
    yardstick = std::min(yardstick, processor_time() - start);
    for (std::size_t c = 0; c < contenders.size(); ++c)
      for (std::size_t a = 0; a < angles.size(); ++a) {
        const Refined r = contenders[c].run(mesh, {.minimum_angle = angles[a]});
        fastest[c][a] = std::min(fastest[c][a], r.milliseconds);
        nlohmann::json entry = row(r, fastest[c][a], yardstick);
        if (c % 2 == 1) entry["ratio_to_double"] = fastest[c][a] / fastest[c - 1][a];
        result[contenders[c].name][std::to_string(static_cast<int>(angles[a]))] = entry;
      }
  }
  result["cgal"]["milliseconds"] = yardstick;
  return result;
}

// The sum of times over all meshes as a multiple of that of another contender, and the greatest
// ratio on one mesh.
struct Comparison {
  std::size_t contender, to;
  double time = 0, other = 0, worst = 0;
  std::string worst_mesh{};

  void add(const std::string& mesh, const std::vector<double>& times) {
    time += times[contender];
    other += times[to];
    if (const double ratio = times[contender] / times[to]; ratio > worst) {
      worst = ratio;
      worst_mesh = mesh;
    }
  }
  nlohmann::json result() const {
    return {{"total", time / other}, {"worst", worst}, {"worst_mesh", worst_mesh}};
  }
};

// Exact refinement to 25 degrees on all meshes of the data set with more than 1,000 faces that take
// a millisecond at least: less is noise.
nlohmann::json measure_data_set(const std::string& directory, std::size_t repetitions) {
  // of the first four contenders: see above
  std::vector<Comparison> comparisons{{1, 0}, {3, 2}, {3, 1}, {1, 2}};
  for (const auto& file : std::filesystem::directory_iterator(directory)) {
    Surface_mesh mesh;
    if (!CGAL::IO::read_polygon_mesh(file.path().string(), mesh) || !is_triangle_mesh(mesh) ||
        num_faces(mesh) <= 1000)
      continue;
    std::vector<double> fastest(4, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < repetitions; ++i)
      for (std::size_t c = 0; c < fastest.size(); ++c)
        fastest[c] = std::min(fastest[c], contenders[c].run(mesh, {}).milliseconds);
    if (*std::min_element(fastest.begin(), fastest.end()) < 1) continue;
    for (Comparison& c : comparisons) c.add(file.path().stem().string(), fastest);
  }
  nlohmann::json result;
  for (const Comparison& c : comparisons)
    result[contenders[c.contender].name + "_by_" + contenders[c.to].name] = c.result();
  return result;
}

// A circumradius that halves the area of faces again and again doubles the vertices.
nlohmann::json measure_linearity(const std::string& directory, double maximum) {
  const Surface_mesh mesh = read_mesh(directory, "camel");
  Lengths_only t(mesh);
  double area = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f);
  nlohmann::json result;
  std::vector<Sample> samples;
  for (double vertices = 62500; vertices <= maximum; vertices *= 2) {
    // inserted vertices at distances of the radius and more: about 0.7 of them per squared radius
    const double radius = std::sqrt(0.7 * area / vertices);
    const Criteria options{.minimum_angle = 25,
                           .maximum_circumradius = radius,
                           .maximum_insertions = 10 * static_cast<std::uint64_t>(vertices)};
    Refined r = run_refinement<Lengths_only>(mesh, options);
    for (int i = 1; i < 3; ++i)
      r.milliseconds =
          std::min(r.milliseconds, run_refinement<Lengths_only>(mesh, options).milliseconds);
    const auto inserted = static_cast<double>(r.inserted);
    samples.push_back({inserted, r.milliseconds});
    result["sizes"].push_back(
        {{"inserted_vertices", r.inserted},
         {"microseconds_per_inserted_vertex", 1e3 * r.milliseconds / inserted}});
    std::cerr << result["sizes"].back().dump() << '\n';
  }
  if (samples.size() > 1) result["exponent"] = exponent(samples);
  return result;
}

nlohmann::json measure_all(const std::string& directory, std::size_t repetitions, double maximum) {
  nlohmann::json result;
  for (const Workload& w : workloads(directory)) {
    const Surface_mesh mesh = w.make();
    const bool is_long = num_faces(mesh) > 150000;
    result["meshes"][w.name] =
        measure(mesh, is_long ? std::min<std::size_t>(repetitions, 2) : repetitions);
    std::cerr << w.name << ' ' << result["meshes"][w.name].dump() << '\n';
  }
  result["data_set"] = measure_data_set(directory, repetitions);
  std::cerr << "data set " << result["data_set"].dump() << '\n';
  result["linearity"] = measure_linearity(directory, maximum);
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::size_t repetitions = argc > 2 ? std::stoul(argv[2]) : 5;
    const double maximum = argc > 3 ? std::stod(argv[3]) : 2e6;
    std::cout << measure_all(mesh_directory(argc, argv), repetitions, maximum).dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "refinement: " << e.what() << '\n';
    return 1;
  }
}
