// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How many vertices does adaptive refinement save, and how much time? The table of Fig. 26 of the
// course: the harmonic Green's function and a heat kernel on coarse models, refined where the
// estimated error is large, and uniformly to the same error.
// Usage: adaptive_refinement [DIRECTORY [MODEL...]] > result.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

template <class Traits>
using Triangulation_with =
    IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;
using Double = Triangulation_with<IT::Euclidean_traits<double>>;
using Exact = Triangulation_with<IT::Exact_euclidean_traits>;
using Vector = Eigen::VectorXd;

constexpr std::uint32_t source = 0;
constexpr double minimum_angle = 25;

// ---- the problems

struct Problem {
  std::string name;
  double time; // 0: the Green's function
  double area;
  std::vector<double> tolerances; // relative to the norm of the solution

  template <class Triangulation>
  Vector solve(Triangulation& t) const {
    return time > 0 ? IT::short_time_heat_kernel(t, source, time)
                    : IT::harmonic_green_function(t, source);
  }
  template <class Triangulation>
  std::vector<double> estimate(const Triangulation& t, const Vector& u) const {
    const IT::Reaction_diffusion equation{time > 0 ? time : 1, time > 0 ? 1.0 : 0};
    const Vector f = Vector::Constant(u.size(), time > 0 ? 0 : -1 / area);
    return IT::residual_indicators(t, equation, u, f, IT::Error_norm::L2);
  }
};

/// The Green's function, and the heat kernel after the time of the heat method: the mean edge
/// squared.
std::vector<Problem> problems(const Surface_mesh& mesh) {
  const Double t(mesh);
  double area = 0, length = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f);
  for (const auto e : edges(t.mesh())) length += std::sqrt(t.squared_length(e));
  length /= static_cast<double>(num_edges(t.mesh()));
  return {{"harmonic Green's function", 0, area, {0.05, 0.02, 0.006}},
          {"short-time heat kernel", length * length, area, {0.2, 0.1, 0.05}}};
}

/// measures the processor's time, as most of it is spent in long runs of one thread.
class Processor_watch {
public:
  double milliseconds() const {
    return 1000. * static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
  }

private:
  std::clock_t start_ = std::clock();
};

template <class Triangulation>
struct Solution {
  Triangulation t;
  Vector u;
  double milliseconds = 0; // all of it: building, refining, solving
};

double norm(const Solution<Double>& s) {
  return std::sqrt(s.u.dot(IT::galerkin_mass_matrix(s.t) * s.u));
}

template <class Triangulation>
Solution<Triangulation> on_input(const Surface_mesh& mesh, const Problem& p) {
  const Processor_watch watch;
  Solution<Triangulation> s{Triangulation(mesh), {}};
  s.u = p.solve(s.t);
  s.milliseconds = watch.milliseconds();
  return s;
}

template <class Triangulation>
Solution<Triangulation> adaptive(const Surface_mesh& mesh, const Problem& p, double tolerance) {
  const Processor_watch watch;
  Solution<Triangulation> s{Triangulation(mesh), {}};
  const auto result = IT::adaptive_refine(
      s.t,
      [&](Triangulation& t) {
        s.u = p.solve(t);
        return p.estimate(t, s.u);
      },
      IT::parameters::tolerance(tolerance).minimum_angle(minimum_angle).maximum_vertices(1000000));
  s.milliseconds = watch.milliseconds();
  if (result.status != IT::Status::done)
    throw std::runtime_error("adaptive refinement does not reach its tolerance");
  return s;
}

template <class Triangulation>
Solution<Triangulation> uniform(const Surface_mesh& mesh, const Problem& p, double radius) {
  const Processor_watch watch;
  Solution<Triangulation> s{Triangulation(mesh), {}};
  IT::delaunay_refine(s.t,
                      IT::parameters::minimum_angle(minimum_angle).maximum_circumradius(radius));
  s.u = p.solve(s.t);
  s.milliseconds = watch.milliseconds();
  return s;
}

// ---- errors: the L2 norm of the difference to a reference, relative to its norm, by the values at
// the centroids of the faces of the reference, which are small where functions are steep

struct Sample {
  IT::Surface_point on_input;
  double value, area;
};

double value(const Solution<Double>& s, const IT::Surface_point& p) {
  const IT::Intrinsic_view<Double> view(s.t);
  const auto at = [&](std::uint32_t h) {
    return s.u[s.t.input_vertex(s.t.numbers().vertex_at(view.source(h)))];
  };
  const std::uint32_t n = view.next(p.halfedge);
  return p.weights[0] * at(p.halfedge) + p.weights[1] * at(n) + p.weights[2] * at(view.next(n));
}

std::vector<Sample> samples(Solution<Double>& s) {
  std::vector<Sample> result;
  for (const auto f : faces(s.t.mesh())) {
    const std::uint32_t h = s.t.numbers().halfedge(halfedge(f, s.t.mesh()));
    const IT::Surface_point centroid{h, {1. / 3, 1. / 3, 1. / 3}};
    const auto l = IT::locate_on_input(s.t, {h, centroid.weights});
    result.push_back({*l, value(s, centroid), s.t.area(f)});
  }
  return result;
}

double error(const Solution<Double>& s, const std::vector<Sample>& samples) {
  double sum = 0, all = 0;
  for (const Sample& x : samples) {
    const auto p = IT::locate_on_intrinsic(s.t, x.on_input);
    if (!p) throw std::runtime_error("a point is not found");
    const double d = value(s, *p) - x.value;
    sum += x.area * d * d;
    all += x.area * x.value * x.value;
  }
  return std::sqrt(sum / all);
}

// ---- the table

struct Row {
  std::size_t vertices;
  double milliseconds, exact_milliseconds, error;
};

/// A row of what `solve` makes with each arithmetic: vertices and error are those with doubles, the
/// time is the fastest of two.
template <class Solve>
Row row(const Solve& solve, const std::vector<Sample>& samples) {
  const Solution<Double> s = solve.template operator()<Double>();
  const double again = solve.template operator()<Double>().milliseconds;
  const double exact = std::min(solve.template operator()<Exact>().milliseconds,
                                solve.template operator()<Exact>().milliseconds);
  return {num_vertices(s.t.mesh()), std::min(s.milliseconds, again), exact, error(s, samples)};
}

nlohmann::json json(const Row& r) {
  return {{"vertices", r.vertices},
          {"milliseconds", r.milliseconds},
          {"exact_milliseconds", r.exact_milliseconds},
          {"error", r.error}};
}

void print(const char* name, const nlohmann::json& r) {
  std::fprintf(stderr, "| %s | %zu | %.3f s | %.3f s | %.5f |\n", name,
               r["vertices"].get<std::size_t>(), r["milliseconds"].get<double>() / 1000,
               r["exact_milliseconds"].get<double>() / 1000, r["error"].get<double>());
}

// refines uniformly, by a factor of about the root of two in vertices, down to an error
std::vector<Row> uniform_rows(const Surface_mesh& mesh, const Problem& p,
                              const std::vector<Sample>& samples, double least_error) {
  std::vector<Row> rows;
  double radius = 0.05 * std::sqrt(p.area);
  do {
    rows.push_back(row([&]<class T>() { return uniform<T>(mesh, p, radius); }, samples));
    print("uniform", json(rows.back()));
    radius *= std::pow(2, -0.25);
  } while (rows.back().error > least_error && rows.back().vertices < 150000);
  return rows;
}

// the first uniform refinement that is not worse, and the last that is: a bound of the ratio
nlohmann::json compare(const Row& adaptive, double estimate, const std::vector<Row>& uniform) {
  nlohmann::json result = {{"adaptive", json(adaptive)}, {"estimate", estimate}};
  std::size_t i = 0;
  while (i < uniform.size() && uniform[i].error > adaptive.error) ++i;
  const double last = i > 0 ? static_cast<double>(uniform[i - 1].vertices) : 0;
  result["ratio_at_least"] = last / static_cast<double>(adaptive.vertices);
  if (i < uniform.size()) result["uniform"] = json(uniform[i]);
  return result;
}

nlohmann::json run(const Surface_mesh& mesh, const Problem& p) {
  const double size = norm(adaptive<Double>(mesh, p, 0.1 * norm(on_input<Double>(mesh, p))));
  Solution<Double> reference = adaptive<Double>(mesh, p, p.tolerances.back() / 6 * size);
  const std::vector<Sample> s = samples(reference);
  nlohmann::json result = {
      {"problem", p.name},
      {"reference_vertices", num_vertices(reference.t.mesh())},
      {"input", json(row([&]<class T>() { return on_input<T>(mesh, p); }, s))}};
  std::fprintf(stderr,
               "\n%s; reference with %zu vertices\n\n| | vertices | double | exact | error |\n"
               "|---|---|---|---|---|\n",
               p.name.c_str(), num_vertices(reference.t.mesh()));
  print("input", result["input"]);
  std::vector<Row> rows;
  for (const double x : p.tolerances) {
    rows.push_back(row([&]<class T>() { return adaptive<T>(mesh, p, x * size); }, s));
    print("adaptive", json(rows.back()));
  }
  const std::vector<Row> others = uniform_rows(mesh, p, s, rows.back().error);
  for (std::size_t i = 0; i < rows.size(); ++i)
    result["rows"].push_back(compare(rows[i], p.tolerances[i], others));
  return result;
}

/// A model of CGAL's data set with edges collapsed until 214 vertices are left, as in the course.
Surface_mesh coarse_model(const std::string& directory, const std::string& name) {
  namespace SMS = CGAL::Surface_mesh_simplification;
  Surface_mesh mesh = read_mesh(directory, name);
  // closed: V - E/3 is the Euler characteristic
  const std::size_t edges = num_edges(mesh) - 3 * (num_vertices(mesh) - 214);
  SMS::edge_collapse(mesh, SMS::Count_stop_predicate<Surface_mesh>(edges + 1)); // stops below
  mesh.collect_garbage();
  return mesh;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::string directory = mesh_directory(argc, argv);
    nlohmann::json result;
    std::vector<std::string> models(argv + std::min(argc, 2), argv + argc);
    if (models.empty()) models = {"elephant", "armadillo"};
    for (const std::string& name : models) {
      const Surface_mesh mesh = coarse_model(directory, name);
      std::fprintf(stderr, "\n%s, %u vertices\n", name.c_str(), unsigned{num_vertices(mesh)});
      for (const Problem& p : problems(mesh)) {
        result["rows"].push_back(run(mesh, p));
        result["rows"].back()["model"] = name;
      }
    }
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "adaptive_refinement: " << e.what() << '\n';
    return 1;
  }
}
