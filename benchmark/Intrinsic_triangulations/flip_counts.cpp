// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How many flips lead to Delaunay, in three orders, and how does their number grow? Exact predicates decide.
// Usage: flip_counts [MAXIMUM_SIZE] > flip_counts.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include "stress_families.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::synthetic::Triangle_soup;
using Triangulation = IT::Intrinsic_triangulation<>;
using Halfedge = Triangulation::halfedge_descriptor;

namespace {

// ---- orders

// Passes over all edges by number, until a pass flips none.
std::uint64_t flip_as_they_come(Triangulation& t) {
  Triangulation::Session session(t);
  std::uint64_t flips = 0, before = 1;
  while (flips != std::exchange(before, flips))
    for (const auto e : edges(t.mesh())) {
      const Halfedge h = halfedge(e, t.mesh());
      if (!session.is_locally_delaunay(h) && session.flip_edge(h) == IT::Move_status::done) ++flips;
    }
  return flips;
}

// First in, first out; the sides of a flipped edge join the queue.
std::uint64_t flip_by_queue(Triangulation& t) {
  Triangulation::Session session(t);
  std::queue<Halfedge> queue;
  std::vector<char> waits(num_edges(t.mesh()), 0);
  const auto push = [&](Halfedge h) {
    if (!std::exchange(waits[t.index(edge(h, t.mesh()))], 1)) queue.push(h);
  };
  for (const auto e : edges(t.mesh())) push(halfedge(e, t.mesh()));
  std::uint64_t flips = 0;
  for (; !queue.empty(); queue.pop()) {
    const Halfedge h = queue.front();
    waits[t.index(edge(h, t.mesh()))] = 0;
    if (session.is_locally_delaunay(h) || session.flip_edge(h) != IT::Move_status::done) continue;
    ++flips;
    for (const Halfedge g : {h, opposite(h, t.mesh())})
      for (const Halfedge side : {next(g, t.mesh()), next(next(g, t.mesh()), t.mesh())}) push(side);
  }
  return flips;
}

std::uint64_t flip_longest_first(Triangulation& t) { return IT::flip_to_delaunay(t).flips; }

const std::vector<std::pair<std::string, std::uint64_t (*)(Triangulation&)>> orders = {
    {"as they come", flip_as_they_come},
    {"queue", flip_by_queue},
    {"longest first", flip_longest_first}};

// ---- families

IT::Intrinsic_input input(const auto& mesh) {
  IT::Triangle_soup soup;
  soup.points = mesh.points;
  if constexpr (requires { mesh.faces; })
    soup.triangles = mesh.faces;
  else
    soup.triangles = mesh.triangles;
  return IT::Intrinsic_input(std::move(soup));
}

// Random points of a square, triangulated from left to right: each is joined to all that it sees.
Triangle_soup swept_points(std::uint32_t n) {
  std::mt19937_64 rng(1);
  Triangle_soup soup;
  for (std::uint32_t i = 0; i < n; ++i)
    soup.points.push_back({IT::synthetic::draw_real(rng), IT::synthetic::draw_real(rng), 0});
  std::sort(soup.points.begin(), soup.points.end());
  const auto turns_left = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto &p = soup.points[a], &q = soup.points[b], &r = soup.points[c];
    return (q[0] - p[0]) * (r[1] - p[1]) > (q[1] - p[1]) * (r[0] - p[0]);
  };
  std::vector<std::uint32_t> lower{0}, upper{0}; // the hull from the first point to the last
  for (std::uint32_t i = 1; i < n; ++i) {
    for (; lower.size() > 1 && turns_left(i, lower.back(), lower.end()[-2]); lower.pop_back())
      soup.triangles.push_back({lower.end()[-2], i, lower.back()});
    for (; upper.size() > 1 && turns_left(upper.end()[-2], upper.back(), i); upper.pop_back())
      soup.triangles.push_back({upper.end()[-2], upper.back(), i});
    lower.push_back(i);
    upper.push_back(i);
  }
  return soup;
}

// The flat torus of the square, with one vertex, and edges that are the vectors (a, b), (c, d) and
// their sum. \pre a d - b c is 1
IT::Intrinsic_input one_vertex_torus(double a, double b, double c, double d) {
  IT::Gluing gluing;
  gluing.number_of_vertices = 1;
  gluing.origin = {0, 0, 0, 0, 0, 0};
  gluing.glue = {3, 4, 5, 0, 1, 2};
  return IT::Intrinsic_input(
      IT::Gluing_map(gluing),
      std::vector<double>{a * a + b * b, c * c + d * d, (a + c) * (a + c) + (b + d) * (b + d)});
}
IT::Intrinsic_input fibonacci_torus(std::uint32_t steps) {
  std::array<double, 4> f{1, 1, 0, 1}; // neighbouring columns are Fibonacci numbers
  for (std::uint32_t i = 0; i < steps; ++i)
    f = i % 2 == 0 ? std::array{f[0], f[1], f[2] + f[0], f[3] + f[1]}
                   : std::array{f[0] + f[2], f[1] + f[3], f[2], f[3]};
  return one_vertex_torus(f[0], f[1], f[2], f[3]);
}

struct Family {
  std::string name;
  std::string size; // what a size is
  std::vector<std::uint32_t> sizes;
  std::function<IT::Intrinsic_input(std::uint32_t)> make;
};

std::vector<Family> families() {
  namespace S = IT::synthetic;
  const std::vector<std::uint32_t> usual{500, 1000, 2000, 4000, 8000, 16000};
  const auto stress = [](const std::string& name, const std::string& amount) {
    return [=](std::uint32_t n) {
      return input(
          stress::make("stress:" + name + ":size=" + std::to_string(n) + ":amount=" + amount));
    };
  };
  return {
      {"random points, swept", "faces", usual, [](auto n) { return input(swept_points(n / 2)); }},
      {"sphere, random splits", "faces", usual, stress("splits", "0.1")},
      {"caps 1e-3", "faces", usual, stress("caps", "1e-3")},
      {"needles 1e-3", "faces", usual, stress("needles", "1e-3")},
      {"torus, shift 2", "faces", usual, [](auto n) { return input(S::torus_of_size(n)); }},
      {"torus, shift by an eighth", "faces", usual,
       [](auto n) {
         const auto rows = static_cast<std::uint32_t>(std::sqrt(n / 4.) + 0.5);
         return input(S::torus(rows, 2 * rows, 0.35, rows / 4, 0.1));
       }},
      {"CAD plate of two fans", "faces", usual,
       [](auto n) { return input(S::sliver_plate(n / 4, 1000, 0.1, true)); }},
      {"CAD plate, cut at random", "faces", usual,
       [](auto n) { return input(S::sliver_plate(n / 4, 100, 0.1, false)); }},
      {"two parabolas",
       "faces",
       {250, 500, 1000, 2000},
       [](auto n) { return input(S::double_parabola(n / 2)); }},
      {"flat torus, sheared",
       "longest edge, about",
       {10, 30, 100, 300, 1000},
       [](auto n) { return one_vertex_torus(1, 0, n, 1); }},
      {"flat torus, Fibonacci",
       "logarithm of the longest edge, about",
       {5, 10, 20, 30},
       fibonacci_torus}};
}

nlohmann::json count(const Family& family, double maximum) {
  nlohmann::json result = {{"name", family.name}, {"size", family.size}};
  std::map<std::string, std::vector<IT::benchmark::Sample>> samples;
  for (const std::uint32_t size : family.sizes) {
    if (size > maximum) break;
    const IT::Intrinsic_input start = family.make(size);
    nlohmann::json row;
    for (const auto& [name, flip] : orders) {
      Triangulation t(start);
      row["size"] = family.size == "faces" ? static_cast<double>(num_faces(t.mesh())) : size;
      row[name] = flip(t);
      if (!IT::is_delaunay(t)) throw std::runtime_error(family.name + " is not Delaunay");
      samples[name].push_back({row["size"], row[name]});
    }
    std::cerr << family.name << ' ' << row.dump() << '\n';
    result["rows"].push_back(row);
  }
  for (const auto& [name, sample] : samples)
    result["exponent"][name] = IT::benchmark::exponent(sample);
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    nlohmann::json result;
    for (const Family& family : families())
      result["families"].push_back(count(family, argc > 1 ? std::stod(argv[1]) : 1e6));
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "flip_counts: " << e.what() << '\n';
    return 1;
  }
}
