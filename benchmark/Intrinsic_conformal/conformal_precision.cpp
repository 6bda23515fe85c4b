// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How many metrics with random cones are found, by the precision of the arithmetic, where lambda
// lengths are scaled by factors over many powers of ten? A plain Newton's method with so many bits
// throughout is compared with `conformal_metric()`, which calculates with doubles. Each result is
// checked with 400 bits.
// Usage: conformal_precision [SETS [POWERS...]] > precision.json

#include "plain_conformal.h"

#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <exception>
#include <iostream>
#include <limits>
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
template <unsigned decimals>
using Float = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<decimals, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;
using Checked = Float<120>; // of 400 bits
constexpr double pi = std::numbers::pi;
constexpr double limit = 1e-8; // of differences of angles, in radians

// A rough sphere with eight meridians of eight vertices.
Mesh rough_sphere() {
  constexpr std::uint32_t rings = 8, around = 8;
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

using Scale = Plain_newton<Checked>::Vector;

// Whether all angles are near the prescribed ones.
bool is_right(const Problem& p, const Scale& u) {
  if (u.size() == 0) return false;
  Plain_newton<Checked> newton = plain_newton<Checked>(p.input, p.angles);
  return Plain_newton<Checked>::size(newton.excess_at(u)) < limit;
}

constexpr unsigned most_steps = 300;

// Empty if the method itself sees that it has failed.
template <class FT>
Scale plain_scale(const Problem& p) {
  Plain_newton<FT> newton = plain_newton<FT>(p.input, p.angles);
  const auto u = newton.solve(most_steps, 1e-10);
  return newton.residual() < 1e-3 ? u.template cast<Checked>() : Scale();
}

template <class Traits>
Scale our_scale(const Problem& p) {
  Triangulation<Traits> t(p.input);
  const std::vector<double> factors =
      IT::conformal_metric(t, p.angles, IT::parameters::number_of_iterations(most_steps))
          .scale_factors;
  Scale u(static_cast<Eigen::Index>(factors.size()));
  for (std::size_t v = 0; v < factors.size(); ++v)
    u[static_cast<Eigen::Index>(v)] = 2 * log(Checked(factors[v]));
  return u;
}

struct Contender {
  std::string name;
  int bits;
  Scale (*scale)(const Problem&);
  std::size_t solved = 0;
  double seconds = 0;
};

template <class FT>
Contender plain_contender() {
  return {"plain", std::numeric_limits<FT>::digits, plain_scale<FT>};
}

double seconds_of_processor() { return double(std::clock()) / CLOCKS_PER_SEC; }

// mpfr takes one to three bits more than so many decimals need
template <unsigned... decimals>
std::vector<Contender> contenders() {
  return {
      plain_contender<double>(),
      plain_contender<Float<decimals>>()...,
      {"conformal_metric, flips in doubles", 53, our_scale<IT::Ideal_hyperbolic_traits<double>>},
      {"conformal_metric, exact flips", 53, our_scale<IT::Exact_ideal_hyperbolic_traits>}};
}

void measure(nlohmann::json& rows, const IT::Intrinsic_input& start, double powers, unsigned sets) {
  std::vector<Contender> all = contenders<19, 24, 30, 33, 35, 38, 45, 48, 50, 53, 60>();
  // angles and weights differ by twice as many powers of ten as factors: log2(100) bits for each
  const double most_bits = 8 * powers;
  for (unsigned seed = 0; seed < sets; ++seed) {
    const Problem p = random_problem(start, num_vertices(start.mesh), powers, seed);
    for (Contender& c : all) {
      if (c.bits > most_bits) continue;
      const double begin = seconds_of_processor();
      const Scale u = c.scale(p);
      c.seconds += seconds_of_processor() - begin;
      if (is_right(p, u)) ++c.solved;
    }
    if (seed % 50 == 49) {
      std::cerr << powers << " powers of ten, " << seed + 1 << " sets:";
      for (const Contender& c : all) std::cerr << ' ' << c.solved;
      std::cerr << '\n';
    }
  }
  for (const Contender& c : all)
    if (c.bits <= most_bits)
      rows.push_back({{"method", c.name},
                      {"bits", c.bits},
                      {"powers", powers},
                      {"sets", sets},
                      {"solved", c.solved},
                      {"seconds", c.seconds}});
}

} // namespace

int main(int argc, char** argv) {
  try {
    const auto sets = static_cast<unsigned>(argc > 1 ? std::stoul(argv[1]) : 1000);
    std::vector<double> powers;
    for (int i = 2; i < argc; ++i) powers.push_back(std::stod(argv[i]));
    if (powers.empty()) powers = {20, 30};
    Triangulation<IT::Exact_euclidean_traits> t(rough_sphere());
    IT::flip_to_delaunay(t);
    const IT::Intrinsic_input start = IT::ideal_start(t);
    nlohmann::json result = {{"vertices", t.number_of_vertices()}, {"limit", limit}};
    for (const double p : powers) measure(result["rows"], start, p, sets);
    std::cout << result.dump(2) << '\n';
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "conformal_precision: " << e.what() << '\n';
    return 1;
  }
}
