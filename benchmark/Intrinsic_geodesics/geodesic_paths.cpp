// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What does a geodesic between two vertices cost, exactly and with doubles? Random pairs on one triangulation: the search along
// edges, the flips that make its path geodesic, tracing, and taking the flips back; and the geodesics from one vertex to all others. Usage:
// geodesic_paths [DIRECTORY [QUERIES [MODEL...]]] > geodesic_paths.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_geodesics/single_source/flip_to_geodesic_tree.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

template <class Traits>
using Triangulation_with =
    IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;

/// Milliseconds of the processor in all, but for the network and for the geodesics from one vertex.
struct Cost {
  double network = 0, search = 0, shorten = 0, slowest = 0, trace = 0, undo = 0, tree = 0;
  std::uint64_t queries = 0, flips = 0;
};

double since(double& last) {
  const double before = last;
  last = processor_time();
  return last - before;
}

/// The median over some sources.
template <class Triangulation>
double tree_cost(const Triangulation& untouched) {
  std::vector<double> times;
  for (std::uint32_t i = 0; i < 5; ++i) {
    Triangulation t(untouched);
    double clock = processor_time();
    flip_to_geodesic_tree(
        t, t.numbers().vertex_at(i * static_cast<std::uint32_t>(num_vertices(t.mesh()) / 5)));
    times.push_back(since(clock));
  }
  return median(times);
}

template <class Traits>
Cost measure(const Surface_mesh& mesh, unsigned queries) {
  using Triangulation = Triangulation_with<Traits>;
  Triangulation t(mesh);
  Cost cost;
  cost.tree = tree_cost(t);
  double clock = processor_time();
  IT::Curve_network<Triangulation> network(t);
  cost.network = since(clock);
  IT::Edge_path_finder<Triangulation> find(t);
  IT::Flip_log<Triangulation> log;
  std::mt19937 random(1);
  const auto vertex = [&] {
    return t.numbers().vertex_at(static_cast<std::uint32_t>(random() % num_vertices(t.mesh())));
  };
  for (unsigned i = 0; i < queries; ++i) {
    const auto from = vertex(), to = vertex();
    since(clock);
    const auto way = find(from, to);
    cost.search += since(clock);
    if (way.empty()) continue;
    network.add_path(way);
    const IT::Shortening_result r = shorten_curves(network, log);
    const double shorten = since(clock);
    cost.shorten += shorten;
    cost.slowest = std::max(cost.slowest, shorten);
    trace_curve(t, network.halfedges(0));
    cost.trace += since(clock);
    network.clear();
    {
      typename Triangulation::Session session(t);
      log.undo(session);
    }
    cost.undo += since(clock);
    ++cost.queries;
    cost.flips += r.flips;
  }
  return cost;
}

nlohmann::json report(const Cost& c) {
  const double n = static_cast<double>(std::max<std::uint64_t>(c.queries, 1));
  return {{"network_ms", c.network},
          {"search_ms", c.search / n},
          {"shorten_ms", c.shorten / n},
          {"slowest_ms", c.slowest},
          {"trace_ms", c.trace / n},
          {"undo_ms", c.undo / n},
          {"queries", c.queries},
          {"flips", static_cast<double>(c.flips) / n},
          {"tree_ms", c.tree}};
}

void compare(const std::string& directory, const std::string& name, unsigned queries,
             nlohmann::json& result) {
  const Surface_mesh mesh = read_mesh(directory, name);
  const Cost exact = measure<IT::Exact_euclidean_traits>(mesh, queries);
  const Cost floating = measure<IT::Euclidean_traits<double>>(mesh, queries);
  const auto n = static_cast<double>(std::max<std::uint64_t>(exact.queries, 1));
  std::fprintf(stderr,
               "%-20s network %6.3f  search %7.3f  shorten %7.3f (double %7.3f, %4.2f)  trace "
               "%6.3f  undo %6.3f ms  %6.0f flips  tree %6.1f ms\n",
               name.c_str(), exact.network, exact.search / n, exact.shorten / n,
               floating.shorten / n, exact.shorten / floating.shorten, exact.trace / n,
               exact.undo / n, static_cast<double>(exact.flips) / n, exact.tree);
  result.push_back({{"model", name}, {"exact", report(exact)}, {"double", report(floating)}});
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    const std::string directory = mesh_directory(argc, argv);
    const unsigned queries = argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1000;
    std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
    if (names.empty()) names = {"armadillo", "camel", "refined_elephant", "cheese"};
    nlohmann::json result = nlohmann::json::array();
    for (const std::string& name : names) compare(directory, name, queries, result);
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
