// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How many metrics with random cones are found, by the arithmetic of flips, where lambda lengths are
// scaled by factors over many powers of ten? Each result is checked with exact flips.
// Usage: conformal_precision [SETS [MOST_POWERS]] > precision.json

#include <CGAL/Intrinsic_operators/conformal/conformal_metric.h>
#include <CGAL/Intrinsic_operators/conformal/ideal_start.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Gmpfr.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
template <class Traits>
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;
using Exact = Triangulation<IT::Exact_ideal_hyperbolic_traits>;
constexpr double pi = std::numbers::pi;

// A rough sphere with meridians of 16 vertices.
Mesh rough_sphere() {
  constexpr std::uint32_t rings = 16, around = 32;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.8, 1.2);
  Mesh mesh;
  const auto add = [&](double polar, double azimuth) {
    const double r = radius(random), s = r * std::sin(polar);
    return mesh.add_vertex({s * std::cos(azimuth), s * std::sin(azimuth), r * std::cos(polar)});
  };
  const auto north = add(0, 0), south = add(pi, 0);
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t k = 0; k < around; ++k)
      add(pi * (i + 0.5) / rings, 2 * pi * (k + 0.5 * i) / around);
  const auto at = [](std::uint32_t i, std::uint32_t k) {
    return Mesh::Vertex_index(2 + around * i + k % around);
  };
  for (std::uint32_t k = 0; k < around; ++k) {
    mesh.add_face(north, at(0, k), at(0, k + 1));
    mesh.add_face(south, at(rings - 1, k + 1), at(rings - 1, k));
    for (std::uint32_t i = 0; i + 1 < rings; ++i) {
      mesh.add_face(at(i, k), at(i + 1, k), at(i, k + 1));
      mesh.add_face(at(i, k + 1), at(i + 1, k), at(i + 1, k + 1));
    }
  }
  return mesh;
}

// A set of 4 to 24 cones, whose curvature sums to 8 quarter turns, and lambda lengths scaled by
// random factors.
struct Problem {
  IT::Intrinsic_input input;
  IT::Prescribed_angles angles;
};

Problem random_problem(const IT::Intrinsic_input& start, std::size_t vertices, double powers,
                       unsigned seed) {
  Problem p{start, IT::Prescribed_angles(vertices)};
  std::mt19937 random(seed);
  std::vector<std::size_t> order(vertices);
  for (std::size_t v = 0; v < vertices; ++v) order[v] = v;
  std::shuffle(order.begin(), order.end(), random);
  // each positive curvature is up to three quarter turns, each negative one up to two
  std::int64_t rest = 8;
  std::size_t cones = 0;
  for (const std::size_t most = 4 + random() % 17; cones < most || rest != 0; ++cones) {
    std::int64_t k = cones < most ? std::int64_t(random() % 6) - 2 : (rest > 0 ? 1 : -1);
    if (cones >= most && std::abs(rest) > 2) k *= 2;
    p.angles.set(order[cones], IT::Multiple_of_pi{4 - k, 2});
    rest -= k;
  }
  std::uniform_real_distribution<double> logarithm(-powers / 2 * std::numbers::ln10,
                                                   powers / 2 * std::numbers::ln10);
  std::vector<double> w(vertices);
  for (double& x : w) x = std::exp(logarithm(random));
  for (std::uint32_t e = 0; e < p.input.squared_lengths.size(); ++e)
    for (const std::uint32_t h : {2 * e, 2 * e + 1})
      p.input.squared_lengths[e] *=
          std::pow(w[p.input.names.row(p.input.mesh.source(IT::Gluing_map::Halfedge{h}).index)], 2);
  return p;
}

// The largest difference from prescribed angles with these factors, by exact flips.
double true_residual(const Problem& p, const std::vector<double>& factors) {
  Exact t(p.input);
  t.scale_vertices(factors);
  IT::flip_to_delaunay(t);
  std::vector<long double> sum(t.number_of_vertices(), 0);
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      const long double a = t.lambda(edge(h, t.mesh())),
                        b = t.lambda(edge(prev(h, t.mesh()), t.mesh())),
                        c = t.lambda(edge(next(h, t.mesh()), t.mesh()));
      const long double square = (c - (a - b)) * (c + (a - b)) / ((a + b + c) * ((a - c) + b));
      sum[t.input_vertex(source(h, t.mesh()))] += 2 * std::atan(std::sqrt(square));
    }
  }
  long double largest = 0;
  for (std::size_t v = 0; v < sum.size(); ++v)
    largest = std::max(largest, std::abs(sum[v] - p.angles.radians(v)));
  return double(largest);
}

struct Count {
  std::size_t solved = 0, sets = 0;
  double seconds = 0;
};

template <class Traits>
void count(Count& c, const Problem& p) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<double> factors;
  try {
    Triangulation<Traits> t(p.input);
    factors =
        IT::conformal_metric(t, p.angles, IT::parameters::number_of_iterations(300)).scale_factors;
  } catch (const IT::Invalid_input&) { // lambda lengths out of range
  }
  c.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ++c.sets;
  if (!factors.empty() && true_residual(p, factors) < 1e-8) ++c.solved;
}

nlohmann::json measure(unsigned sets, double most) {
  Triangulation<IT::Exact_euclidean_traits> t(rough_sphere());
  IT::flip_to_delaunay(t);
  const IT::Intrinsic_input start = IT::ideal_start(t);
  nlohmann::json result = {{"vertices", t.number_of_vertices()}, {"limit", 1e-8}};
  const std::vector<std::string> names = {"53 bits", "64 bits", "100 bits", "150 bits", "exact"};
  for (double powers = 0; powers <= most; powers += 10) {
    std::vector<Count> counts(names.size());
    for (unsigned seed = 0; seed < sets; ++seed) {
      const Problem p = random_problem(start, t.number_of_vertices(), powers, seed);
      count<IT::Ideal_hyperbolic_traits<double>>(counts[0], p);
      for (const std::size_t i : {1U, 2U, 3U}) {
        CGAL::Gmpfr::set_default_precision(i == 1 ? 64 : i == 2 ? 100 : 150);
        count<IT::Ideal_hyperbolic_traits<CGAL::Gmpfr>>(counts[i], p);
      }
      count<IT::Exact_ideal_hyperbolic_traits>(counts[4], p);
    }
    for (std::size_t i = 0; i < names.size(); ++i)
      result["rows"].push_back({{"arithmetic", names[i]},
                                {"powers", powers},
                                {"sets", counts[i].sets},
                                {"solved", counts[i].solved},
                                {"seconds", counts[i].seconds}});
    std::cerr << powers << " powers of ten\n";
  }
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const auto sets = static_cast<unsigned>(argc > 1 ? std::stoul(argv[1]) : 200);
    std::cout << measure(sets, argc > 2 ? std::stod(argv[2]) : 60).dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "conformal_precision: " << e.what() << '\n';
    return 1;
  }
}
